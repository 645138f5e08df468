package org.u2sa.vision.object;

/** What is recognised, by the names that worlds and planners use for it. */
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

  /** As in {@link org.u2sa.messages.ObjectDescription#objectType}. */
  public String typeName() {
    return typeName;
  }
}
