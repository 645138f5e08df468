package org.u2sa.device.payload;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.device.SlewLimit;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/** One axis of a gimbal: its limits and the angle at which it is held. Not thread-safe. */
final class GimbalAxis {
  private static final double FULL_PERCENT = 100.0;

  private final String name;
  private final double minimumRad;
  private final double maximumRad;
  private final double rateRadPerS;
  private final double fullRad;
  private final SlewLimit slew;

  GimbalAxis(String name, double minimumRad, double maximumRad, double rateRadPerS) {
    this.name = name;
    this.minimumRad = minimumRad;
    this.maximumRad = maximumRad;
    this.rateRadPerS = rateRadPerS;
    fullRad = Math.max(Math.max(-minimumRad, maximumRad), 1.0e-3);
    slew = new SlewLimit(FULL_PERCENT * rateRadPerS / fullRad);
  }

  String name() {
    return name;
  }

  ActuatorAnnouncement announcement(String subsystem, String effect) {
    return new ActuatorAnnouncement()
        .actuatorName(name)
        .subsystem(subsystem)
        .minimum(FULL_PERCENT * minimumRad / fullRad)
        .maximum(FULL_PERCENT * maximumRad / fullRad)
        .rateLimit(FULL_PERCENT * rateRadPerS / fullRad)
        .fullAngle(fullRad)
        .commandTypes(List.of("AngleCommand"))
        .effect(String.format(Locale.ROOT, effect, Math.toDegrees(fullRad)));
  }

  /** Moves one step toward a commanded percentage; returns the angle to hold [rad]. */
  double step(OptionalDouble percent, WithoutCommands rest, long nowMicros) {
    double resting = rest == WithoutCommands.HOLD ? slew.percent() : 0.0;
    return fullRad * slew.towards(percent.orElse(resting), nowMicros) / FULL_PERCENT;
  }

  double percent() {
    return slew.percent();
  }

  void goOnFrom(double percent) {
    slew.goOnFrom(percent);
  }
}
