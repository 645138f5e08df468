package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.command.ForceCommand;
import org.u2sa.messages.command.SpeedCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

/**
 * What the fourth format brought for actuators: effects as numbers, commands beside percentages.
 */
final class GoldenActuators {
  private GoldenActuators() {}

  static void addTo(GoldenMessages golden) {
    golden.add(
        "ActuatorAnnouncement-effect",
        new ActuatorAnnouncement()
            .actuatorName("THRUSTER 1")
            .minimum(-100.0)
            .maximum(100.0)
            .effect("pushes forward and left")
            .rateLimit(400.0)
            .deadband(6.25)
            .timeConstant(0.125)
            .force(Point.of(28.0, -28.0, 0.0))
            .moment(Point.of(0.0, 0.5, -6.75))
            .reverseForce(Point.of(-22.0, 22.0, 0.0))
            .reverseMoment(Point.of(0.0, -0.375, 5.25))
            .exponent(2.0)
            .referenceSpeed(1.5)
            .fullAngle(0.5)
            .fullSpeed(314.0)
            .available(75.0)
            .renewal(0.25)
            .serviceName("Thrusters")
            .commandTypes(List.of("ForceCommand", "SpeedCommand")));
    golden.add("AngleCommand", AngleCommand.of("RUDDER", -0.25).expiry(0.5));
    golden.add("SpeedCommand", SpeedCommand.of("LEFT MOTOR", 12.5));
    golden.add("ForceCommand", ForceCommand.of("THRUSTER 1", -17.5).expiry(0.25));
  }
}
