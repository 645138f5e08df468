package org.u2sa.scenarios.robosub.course;

import java.util.Locale;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;

/** Places a layout's objects in the world. */
final class SubObjects {
  private SubObjects() {}

  /** Type of an object, such as "red buoy". */
  static String type(Colour colour, String kind) {
    return colour.name().toLowerCase(Locale.ROOT) + " " + kind;
  }

  /** Whether the rules let the vehicle touch an object. */
  static boolean isTouchable(ObjectDescription object) {
    return object.level().filter(ObjectLevel.HINDRANCE::equals).isPresent();
  }

  /** Places an object whose UID is its type; {@code at} is north, east, down from the start [m]. */
  static ObjectDescription placed(ObjectDescription object, String type, Point at) {
    object
        .uid(type)
        .objectType(type)
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(at.y())
        .y(at.x())
        .z(-at.z())
        .level(object instanceof Buoy ? ObjectLevel.HINDRANCE : ObjectLevel.AVOID_ALWAYS);
    object.freeze();
    return object;
  }
}
