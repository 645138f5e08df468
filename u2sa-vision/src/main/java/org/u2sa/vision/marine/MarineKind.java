package org.u2sa.vision.marine;

import java.util.Locale;
import java.util.Optional;

/** Kinds of objects that a {@link MarineCamera} detects. */
enum MarineKind {
  BUOY("Buoy", "buoy"),
  POLE("Pole", "pole"),
  HOOP("Hoop", "hoop"),
  BUTTON("Button", "button"),
  DOCK("Dock", "dock"),
  BIN("Bin", "bin"),
  PATH_MARKER("PathMarker", "path marker"),
  HOT_TARGET("HotTarget", "hot target");

  private final String className;
  private final String typeName;

  MarineKind(String className, String typeName) {
    this.className = className;
    this.typeName = typeName;
  }

  /** Name as an object's type: "buoy". */
  String typeName() {
    return typeName;
  }

  /** Kind of a class name, "Buoy", or of an object type, "red buoy"; empty if it is neither. */
  static Optional<MarineKind> of(String name) {
    String lower = name.trim().toLowerCase(Locale.ROOT);
    for (MarineKind kind : values()) {
      boolean isType = lower.equals(kind.typeName) || lower.endsWith(" " + kind.typeName);
      if (isType || lower.equals(kind.className.toLowerCase(Locale.ROOT))) {
        return Optional.of(kind);
      }
    }
    return Optional.empty();
  }
}
