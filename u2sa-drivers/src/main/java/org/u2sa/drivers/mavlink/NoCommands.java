package org.u2sa.drivers.mavlink;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;

/** The autopilot is a sensor only. */
final class NoCommands implements CommandForm {
  @Override
  public List<Axis> axes() {
    return List.of();
  }

  @Override
  public Object message(
      Target target, Function<String, OptionalDouble> percentages, long nowMicros) {
    throw new IllegalStateException("nothing is commanded");
  }

  @Override
  public List<Object> release(Target target) {
    return List.of();
  }
}
