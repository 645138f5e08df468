package org.u2sa.device;

import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import java.util.stream.Stream;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes a velocity log's measurements, in BODY: bottom track as velocity, water track as
 * velocity through the fluid; their difference is the current. Out: sensed-state, once per reading
 * with a valid value.
 */
public final class WaterSpeedSensor extends DeviceSensor<VelocityLog.Speeds> {
  private static final SensorKind<VelocityLog> KIND =
      new SensorKind<>(
          "WaterSpeedSensor",
          VelocityLog.class,
          new Devices.Usual(
              "velocity log", "LOG", "WATER LINKED", "serial:/dev/ttyUSB0?baud=115200"),
          Channels.SENSED_STATE,
          50.0, // Hz
          2.0); // s

  private record Variables(
      @Variable(unit = "m/s", min = 0.0001, max = 10, ifAbsent = 0.02)
          @Description("Standard deviation of each speed over the bottom, from the data sheet.")
          double groundSigma,
      @Variable(unit = "m/s", min = 0.0001, max = 10, ifAbsent = 0.05)
          @Description("Standard deviation of each speed through the water, from the data sheet.")
          double waterSigma,
      @Variable(unit = "s", min = 0, max = 5, ifAbsent = 0)
          @Description(
              "Latency from measurement to arrival of a reading, from the data sheet; states are timestamped with the time of measurement. In waves, an unknown one becomes an error of altitude.")
          double delay) {}

  private final Settings<Variables> tuning = settings(Variables.class);

  public WaterSpeedSensor(ServiceContext context) {
    super(context, KIND);
  }

  public WaterSpeedSensor(ServiceContext context, VelocityLog velocityLog) {
    super(context, KIND, velocityLog);
  }

  @Override
  protected Stream<StateInformation> messages(VelocityLog.Speeds speeds) {
    if (!speeds.isAny()) {
      return Stream.empty();
    }
    double ground = tuning.get().groundSigma();
    double water = tuning.get().waterSigma();
    StateInformation state =
        new StateInformation().sensorName(sensorName()).referenceFrame(ReferenceFrame.BODY);
    state.timestamp(speeds.measuredAtMicros() - Clock.micros(tuning.get().delay()));
    set(speeds.groundX(), mps -> state.xDot(mps).xDotSigma(ground));
    set(speeds.groundY(), mps -> state.yDot(mps).yDotSigma(ground));
    set(speeds.groundZ(), mps -> state.zDot(mps).zDotSigma(ground));
    set(speeds.waterX(), mps -> state.fluidxDot(mps).fluidxDotSigma(water));
    set(speeds.waterY(), mps -> state.fluidyDot(mps).fluidyDotSigma(water));
    set(speeds.waterZ(), mps -> state.fluidzDot(mps).fluidzDotSigma(water));
    return Stream.of(state);
  }

  private static void set(OptionalDouble mps, DoubleFunction<StateInformation> setter) {
    if (mps.isPresent()) {
      setter.apply(mps.getAsDouble());
    }
  }
}
