package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.device.wheel.OdometryVariables;
import org.u2sa.device.wheel.WheelOdometry;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/**
 * Publishes speed and yaw rate of a differential vehicle, in BODY, from standalone encoders; for
 * encoders of a motor controller see {@link WheelMotors} (thesis 4.1.1.1). Out: sensed-state.
 */
public final class WheelEncoderSensor extends DeviceSensor<WheelEncoder.Ticks> {
  private static final SensorKind<WheelEncoder> KIND =
      new SensorKind<>(
          "WheelEncoderSensor",
          WheelEncoder.class,
          new Devices.Usual(
              "wheel encoder",
              "ENCODERS",
              "LINUX COUNTER",
              "/sys/bus/counter/devices/counter0/count0/count"),
          Channels.SENSED_STATE,
          50.0, // Hz
          0.5); // s

  private record Variables(
      @Variable(ifAbsentText = "false") @Description("Whether the left wheel counts backwards.")
          boolean leftReversed,
      @Variable(ifAbsentText = "false") @Description("Whether the right wheel counts backwards.")
          boolean rightReversed,
      @Variable(unit = "Hz", min = 0.1, max = 50, ifAbsent = 10)
          @Description("Rate of published speeds.")
          double stateRate) {}

  private final Variables tuning = settings(Variables.class).get();
  private final WheelOdometry odometry = settings(OdometryVariables.class).get().odometry();
  private int connections;
  private long dueMicros = Long.MIN_VALUE;

  public WheelEncoderSensor(ServiceContext context) {
    super(context, KIND);
  }

  public WheelEncoderSensor(ServiceContext context, WheelEncoder encoder) {
    super(context, KIND, encoder);
  }

  @Override
  protected Stream<StateInformation> messages(WheelEncoder.Ticks ticks) {
    if (device().connections() != connections) {
      connections = device().connections();
      odometry.reset(); // counters may have been reset
    }
    long at = ticks.measuredAtMicros();
    if (at < dueMicros) {
      return Stream.empty();
    }
    dueMicros = at + Clock.micros(1.0 / tuning.stateRate());
    int left = tuning.leftReversed() ? -ticks.left() : ticks.left();
    int right = tuning.rightReversed() ? -ticks.right() : ticks.right();
    return odometry.moved(at, left, right).map(state -> state.sensorName(sensorName())).stream();
  }
}
