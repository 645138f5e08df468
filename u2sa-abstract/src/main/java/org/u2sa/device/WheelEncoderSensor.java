package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes speed and yaw rate of a differential vehicle, in BODY, from standalone encoders; {@link
 * WheelMotors} does so for those of a motor controller (thesis 4.1.1.1). Out: sensed-state.
 */
public final class WheelEncoderSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0;

  private static final Devices.Usual USUAL =
      new Devices.Usual(
          "encoders",
          "ENCODERS",
          "LINUX COUNTER",
          "/sys/bus/counter/devices/counter0/count0/count");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.05,
              max = 60,
              ifAbsent = 0.5,
              text = "Time without readable counts after which the encoders count as silent.")
          double timeout,
      @Variable(ifAbsentText = "false", text = "Whether the left wheel counts backwards.")
          boolean leftReversed,
      @Variable(ifAbsentText = "false", text = "Whether the right wheel counts backwards.")
          boolean rightReversed,
      @Variable(unit = "Hz", min = 0.1, max = 50, ifAbsent = 10, text = "Rate of published speeds.")
          double stateRate) {}

  private final WheelEncoder encoder;
  private final DeviceReader<WheelEncoder.Ticks> reader;
  private final WheelOdometry odometry;
  private final int leftSign;
  private final int rightSign;
  private final long everyMicros;
  private long dueMicros = Long.MIN_VALUE;

  /** Launcher constructor: opens the configured encoders. */
  public WheelEncoderSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given encoders, e.g. simulated ones. */
  public WheelEncoderSensor(ServiceContext context, WheelEncoder encoder) {
    this(context, Optional.of(encoder));
  }

  private WheelEncoderSensor(ServiceContext context, Optional<WheelEncoder> made) {
    super(context, "WheelEncoderSensor", STEPS_PER_S);
    Tuning tuning = settings(Tuning.class).get();
    odometry = settings(OdometryVariables.class).get().odometry();
    leftSign = tuning.leftReversed() ? -1 : 1;
    rightSign = tuning.rightReversed() ? -1 : 1;
    everyMicros = Clock.micros(1.0 / tuning.stateRate());
    encoder = Devices.open(WheelEncoder.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the wheel encoder", encoder, tuning.timeout());
  }

  @Override
  protected void step(double nowS) {
    Optional<WheelEncoder.Ticks> ticks = reader.next(clock().micros());
    if (!encoder.isConnected()) {
      odometry.beginAnew(); // counters may have been reset
    }
    ticks.filter(news -> news.measuredAtMicros() >= dueMicros).ifPresent(this::use);
  }

  private void use(WheelEncoder.Ticks ticks) {
    long at = ticks.measuredAtMicros();
    dueMicros = at + everyMicros;
    odometry
        .moved(at, leftSign * ticks.left(), rightSign * ticks.right())
        .ifPresent(state -> publish(Channels.SENSED_STATE, state.sensorName(sensorName())));
  }

  @Override
  protected void release() {
    encoder.close();
  }
}
