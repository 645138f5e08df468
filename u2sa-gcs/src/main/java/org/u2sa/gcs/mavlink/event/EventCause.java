package org.u2sa.gcs.mavlink.event;

import java.util.List;
import java.util.Locale;

/**
 * Causes of a failsafe or a refusal to arm, as bits because an event carries no text. Declared in
 * bit order.
 */
enum EventCause {
  OPERATOR_LINK,
  POSITION,
  STATE_ESTIMATOR,
  ACTUATOR_LINK,
  ACTUATION_REFUSED,
  HEALTH_MONITOR,
  SERVICE,
  LOW_BATTERY,
  CRITICAL_BATTERY,
  BATTERY_SENSOR,
  GEOFENCE,
  EMERGENCY_STOP,
  MISSION,
  ACTUATORS,
  FAILSAFE_MATRIX,
  OTHER;

  /** Prefixes of the Safety Manager's texts. */
  String words() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  int bit() {
    return 1 << ordinal();
  }

  private static EventCause of(String text) {
    for (EventCause each : values()) {
      if (text.startsWith(each.words())) {
        return each;
      }
    }
    return OTHER;
  }

  /** Bits of the Safety Manager's texts. */
  static int bits(List<String> texts) {
    return texts.stream().mapToInt(text -> of(text).bit()).reduce(0, (a, b) -> a | b);
  }
}
