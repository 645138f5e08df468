package {{package}};

import java.util.List;
import java.util.Set;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Replaces the device drivers of a differential-drive ground vehicle with a simulation: it moves as commanded, without mass or slip, and measures its position exactly. In: actuation. Out:
 * sensed-state, actuators.
 */
public final class SimulatedRover extends ProprioceptiveSensor {
  private static final double RATE_HZ = 20.0;
  private static final List<String> MOTORS = List.of("LEFT MOTOR", "RIGHT MOTOR");

  private record Variables(
      @Variable(unit = "m", min = 0.05, max = 5, ifAbsent = 0.5)
          @Description("Distance between the wheels.")
          double track,
      @Variable(unit = "m/s", min = 0.1, max = 20, ifAbsent = 2)
          @Description("Speed at full power of both motors.")
          double maxSpeed) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final CommandedActuators motors;
  private double northM;
  private double eastM;
  private double headingRad; // clockwise from north

  public SimulatedRover(ServiceContext context) {
    super(context, "SimulatedRover", RATE_HZ);
    // Without mass it stops immediately: each step asks for percentages, and a stopped motor
    // has none.
    motors = new CommandedActuators(this, Set.copyOf(MOTORS), () -> {});
  }

  @Override
  protected void begin() {
    motors.announce(MOTORS.stream().map(SimulatedRover::announcement).toList());
  }

  private static ActuatorAnnouncement announcement(String motor) {
    return new ActuatorAnnouncement().actuatorName(motor).minimum(-100.0).maximum(100.0);
  }

  @Override
  protected void step(double nowS) {
    motors.step(nowS);
    double left = speedMps(MOTORS.get(0));
    double right = speedMps(MOTORS.get(1));
    double speed = (left + right) / 2.0;
    double turnRate = (left - right) / tuning.get().track(); // clockwise positive
    double northMps = speed * Math.cos(headingRad);
    double eastMps = speed * Math.sin(headingRad);
    northM += northMps * periodS();
    eastM += eastMps * periodS();
    headingRad = Math.IEEEremainder(headingRad + turnRate * periodS(), 2.0 * Math.PI);
    publish(
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(northM)
            .y(eastM)
            .psi(headingRad)
            .xDot(northMps)
            .yDot(eastMps)
            .psiDot(turnRate));
  }

  private double speedMps(String motor) {
    return motors.percentage(motor).orElse(0.0) / 100.0 * tuning.get().maxSpeed();
  }
}
