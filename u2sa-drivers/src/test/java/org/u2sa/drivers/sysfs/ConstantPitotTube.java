package org.u2sa.drivers.sysfs;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.PitotTube;

/** Always the same difference, and nothing else. */
final class ConstantPitotTube implements PitotTube {
  private final double pascals;

  ConstantPitotTube(double pascals) {
    this.pascals = pascals;
  }

  @Override
  public Optional<Impact> read(long nowMicros) {
    return Optional.of(
        new Impact(nowMicros, pascals, OptionalDouble.empty(), OptionalDouble.empty()));
  }
}
