package org.u2sa.gcs.mavlink;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.gcs.mavlink.station.GroundStation;

/** Decides whether a message is addressed to this vehicle; target 0 is a broadcast. */
final class MessageTargets {
  private record Fields(Optional<Method> system, Optional<Method> component) {}

  private final Map<Class<?>, Fields> known = new HashMap<>();
  private final int systemId;

  MessageTargets(int systemId) {
    this.systemId = systemId;
  }

  boolean include(Object message) {
    Fields fields =
        known.computeIfAbsent(
            message.getClass(),
            type -> new Fields(getter(type, "targetSystem"), getter(type, "targetComponent")));
    int system = fields.system().map(each -> value(each, message)).orElse(0);
    int component = fields.component().map(each -> value(each, message)).orElse(0);
    return (system == 0 || system == systemId)
        && (component == 0 || component == GroundStation.AUTOPILOT);
  }

  private static Optional<Method> getter(Class<?> type, String name) {
    try {
      return Optional.of(type.getMethod(name));
    } catch (NoSuchMethodException e) {
      return Optional.empty(); // a message without a target
    }
  }

  private static int value(Method getter, Object message) {
    try {
      return (Integer) getter.invoke(message);
    } catch (IllegalAccessException | InvocationTargetException e) {
      throw new IllegalStateException(getter + ": expected a public getter that does not throw", e);
    }
  }
}
