package org.u2sa.vision.object;

/** Kinds of detected objects, with the type names used by worlds and planners. */
public enum ObjectKind {
  /** A traffic barrel, orange with white bands. */
  BARREL("barrel"),
  /** A trestle with a striped plank. */
  SAWHORSE("sawhorse"),
  /** A flag to be passed on its left. */
  RED_FLAG("red flag"),
  /** A flag to be passed on its right. */
  BLUE_FLAG("blue flag");

  private final String typeName;

  ObjectKind(String typeName) {
    this.typeName = typeName;
  }

  /** Name for {@link org.u2sa.messages.ObjectDescription#objectType}. */
  public String typeName() {
    return typeName;
  }
}
