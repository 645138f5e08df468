package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.Barometer;
import org.u2sa.device.port.Pressure;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the altitude above mean sea level from a barometer's pressure, in GLOBAL, once per
 * reading. QNH and both sigmas may be changed in flight. Out: sensed-state.
 */
public final class BarometerSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0;
  private static final double MIN_PA = 5_000.0; // 20 km; lower pressures are implausible
  private static final double MAX_PA = 120_000.0;

  private static final Devices.Usual USUAL =
      new Devices.Usual(
          "barometer", "BAROMETER", "IIO", "/sys/bus/iio/devices/iio:device0/in_pressure_input");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.05,
              max = 60,
              ifAbsent = 1,
              text = "Time without a readable pressure after which the barometer counts as silent.")
          double timeout,
      @Variable(
              unit = "Pa",
              min = 85_000,
              max = 110_000,
              ifAbsent = PressureAltitude.SEA_LEVEL_PA,
              text = "Pressure at sea level today: 101325 is the standard atmosphere's.")
          double qnh,
      @Variable(
              unit = "m",
              min = 0.01,
              max = 1000,
              ifAbsent = 100,
              text =
                  "Standard deviation of the altitude. Weather moves it by 100 m while QNH is not today's.")
          double altitudeSigma) {}

  private final Barometer barometer;
  private final DeviceReader<Pressure> reader;
  private final Settings<Tuning> tuning;
  private long refused;

  /** Launcher constructor: opens the configured barometer. */
  public BarometerSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given barometer, e.g. a simulated one. */
  public BarometerSensor(ServiceContext context, Barometer barometer) {
    this(context, Optional.of(barometer));
  }

  private BarometerSensor(ServiceContext context, Optional<Barometer> made) {
    super(context, "BarometerSensor", STEPS_PER_S);
    tuning = settings(Tuning.class);
    barometer = Devices.open(Barometer.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the barometer", barometer, tuning.get().timeout());
  }

  @Override
  protected void step(double nowS) {
    reader.next(clock().micros()).ifPresent(this::use);
  }

  private void use(Pressure pressure) {
    if (!(pressure.pascals() >= MIN_PA && pressure.pascals() <= MAX_PA)) {
      if (Long.bitCount(++refused) == 1) { // 1, 2, 4, 8…: limits the log
        trouble(
            ("the barometer says " + pressure.pascals() + " Pa, which is outside ")
                + (MIN_PA + "…" + MAX_PA + " Pa (" + refused + " times so far)"));
      }
      return;
    }
    StateInformation state =
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.GLOBAL)
            .z(PressureAltitude.altitudeM(pressure.pascals(), tuning.get().qnh()))
            .zSigma(tuning.get().altitudeSigma());
    state.timestamp(pressure.measuredAtMicros());
    publish(Channels.SENSED_STATE, state);
  }

  @Override
  protected void release() {
    barometer.close();
  }
}
