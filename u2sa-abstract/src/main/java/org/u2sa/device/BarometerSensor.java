package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.port.Barometer;
import org.u2sa.device.port.Pressure;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.device.pressure.PressureReference;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the altitude above mean sea level from a barometer's pressure, in GLOBAL, once per
 * reading. QNH and both sigmas may be changed in flight. In: ground-pressure, and state for
 * checking the QNH. Out: sensed-state.
 */
public final class BarometerSensor extends DeviceSensor<Pressure> {
  private static final double MIN_PA = 5_000.0; // 20 km; lower pressures are implausible
  private static final double MAX_PA = 120_000.0;

  private static final SensorKind<Barometer> KIND =
      new SensorKind<>(
          "BarometerSensor",
          Barometer.class,
          new Devices.Usual(
              "barometer",
              "BAROMETER",
              "IIO",
              "/sys/bus/iio/devices/iio:device0/in_pressure_input"),
          Channels.SENSED_STATE,
          50.0, // Hz
          1.0); // s

  private record Variables(
      @Variable(unit = "Pa", min = 85_000, max = 110_000, ifAbsent = PressureAltitude.SEA_LEVEL_PA)
          @Description("Current sea-level pressure; 101325 in the standard atmosphere.")
          double qnh,
      @Variable(unit = "m", min = 0.01, max = 1000, ifAbsent = 100)
          @Description(
              "Standard deviation of the altitude; with an outdated QNH, weather causes errors of up to 100 m.")
          double altitudeSigma,
      @Variable(unit = "m", min = 10, max = 10_000, ifAbsent = 30)
          @Description(
              "Difference from a reliable altitude at which a QNH counts as wrong and is replaced by a fitted one.")
          double qnhTolerance) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final PressureReference reference = new PressureReference(this::trouble);
  private long refused;

  public BarometerSensor(ServiceContext context) {
    super(context, KIND);
    listen();
  }

  public BarometerSensor(ServiceContext context, Barometer barometer) {
    super(context, KIND, barometer);
    listen();
  }

  private void listen() {
    handleMessagesAtSteps();
    reference.configure(tuning.get().qnh());
    subscribe(Channels.STATE, reference::see);
    subscribe(Channels.GROUND_PRESSURE, told -> reference.hear(told, clock().micros()));
  }

  @Override
  protected Stream<StateInformation> messages(Pressure pressure) {
    if (!(pressure.pascals() >= MIN_PA && pressure.pascals() <= MAX_PA)) {
      if (Long.bitCount(++refused) == 1) { // 1, 2, 4, 8…: limits the log
        trouble(
            ("the barometer reports " + pressure.pascals() + " Pa, which is outside ")
                + (MIN_PA + "…" + MAX_PA + " Pa (" + refused + " times so far)"));
      }
      return Stream.empty();
    }
    Variables now = tuning.get();
    reference.configure(now.qnh());
    reference.tolerate(now.qnhTolerance());
    double altitudeM = reference.altitudeM(pressure.pascals(), pressure.measuredAtMicros());
    remark("QNH", reference.toString());
    return Stream.of(
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.GLOBAL)
            .z(altitudeM)
            .zSigma(reference.sigmaM(now.altitudeSigma())));
  }
}
