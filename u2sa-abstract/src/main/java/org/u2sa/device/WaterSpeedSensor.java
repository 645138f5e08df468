package org.u2sa.device;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes a velocity log's measurements, in BODY: bottom track as velocity, water track as
 * velocity through the fluid; their difference is the current. Out: sensed-state, once per reading
 * with a valid value.
 */
public final class WaterSpeedSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0;

  private static final Devices.Usual USUAL =
      new Devices.Usual("velocity log", "LOG", "WATER LINKED", "serial:/dev/ttyUSB0?baud=115200");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.1,
              max = 60,
              ifAbsent = 2,
              text = "Time without a readable message after which the log counts as silent.")
          double timeout,
      @Variable(
              unit = "m/s",
              min = 0.0001,
              max = 10,
              ifAbsent = 0.02,
              text = "Standard deviation of each speed over the bottom, from the data sheet.")
          double groundSigma,
      @Variable(
              unit = "m/s",
              min = 0.0001,
              max = 10,
              ifAbsent = 0.05,
              text = "Standard deviation of each speed through the water, from the data sheet.")
          double waterSigma) {}

  private final VelocityLog velocityLog;
  private final DeviceReader<VelocityLog.Speeds> reader;
  private final Settings<Tuning> tuning;

  /** Launcher constructor: opens the configured log. */
  public WaterSpeedSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given velocity log, e.g. a simulated one. */
  public WaterSpeedSensor(ServiceContext context, VelocityLog velocityLog) {
    this(context, Optional.of(velocityLog));
  }

  private WaterSpeedSensor(ServiceContext context, Optional<VelocityLog> made) {
    super(context, "WaterSpeedSensor", STEPS_PER_S);
    tuning = settings(Tuning.class);
    velocityLog = Devices.open(VelocityLog.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the velocity log", velocityLog, tuning.get().timeout());
  }

  @Override
  protected void step(double nowS) {
    reader
        .next(clock().micros())
        .filter(VelocityLog.Speeds::isAny)
        .ifPresent(speeds -> publish(Channels.SENSED_STATE, state(speeds)));
  }

  private StateInformation state(VelocityLog.Speeds speeds) {
    double ground = tuning.get().groundSigma();
    double water = tuning.get().waterSigma();
    StateInformation state =
        new StateInformation().sensorName(sensorName()).referenceFrame(ReferenceFrame.BODY);
    set(speeds.groundX(), mps -> state.xDot(mps).xDotSigma(ground));
    set(speeds.groundY(), mps -> state.yDot(mps).yDotSigma(ground));
    set(speeds.groundZ(), mps -> state.zDot(mps).zDotSigma(ground));
    set(speeds.waterX(), mps -> state.fluidxDot(mps).fluidxDotSigma(water));
    set(speeds.waterY(), mps -> state.fluidyDot(mps).fluidyDotSigma(water));
    set(speeds.waterZ(), mps -> state.fluidzDot(mps).fluidzDotSigma(water));
    state.timestamp(speeds.measuredAtMicros());
    return state;
  }

  private static void set(OptionalDouble mps, DoubleFunction<StateInformation> setter) {
    if (mps.isPresent()) {
      setter.apply(mps.getAsDouble());
    }
  }

  @Override
  protected void release() {
    velocityLog.close();
  }
}
