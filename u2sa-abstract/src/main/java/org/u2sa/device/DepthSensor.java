package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.DepthGauge;
import org.u2sa.device.port.Pressure;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the depth of a vehicle, once per reading of an underwater pressure sensor: as altitude
 * in GLOBAL, or as z of a local frame. Out: sensed-state.
 */
public final class DepthSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0;

  private static final Devices.Usual USUAL =
      new Devices.Usual(
          "depth gauge",
          "DEPTH GAUGE",
          "IIO",
          "/sys/bus/iio/devices/iio:device0/in_pressure_input");

  /** Frame of the published depth. */
  enum DepthFrame {
    GLOBAL,
    LOCAL_ENU,
    LOCAL_NED
  }

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.05,
              max = 60,
              ifAbsent = 1,
              text = "Time without a readable pressure after which the gauge counts as silent.")
          double timeout,
      @Variable(
              unit = "kg/m^3",
              min = 900,
              max = 1300,
              ifAbsent = 1025,
              text = "Density of the water: 1025 for the sea, 998 for a pool.")
          double waterDensity,
      @Variable(
              unit = "Pa",
              min = 0,
              max = 110_000,
              ifAbsent = PressureAltitude.SEA_LEVEL_PA,
              text = "Pressure of the air at the surface; 0 for a gauge that measures against it.")
          double surfacePressure,
      @Variable(
              unit = "m",
              min = -500,
              max = 9000,
              ifAbsent = 0,
              text = "GLOBAL: altitude of the water's surface above mean sea level.")
          double waterLevel,
      @Variable(
              name = "MOUNTED Z",
              unit = "m",
              min = -100,
              max = 100,
              ifAbsent = 0,
              text = "Place of the gauge on the vehicle, down.")
          double mountedZ,
      @Variable(
              unit = "m",
              min = 0.001,
              max = 100,
              ifAbsent = 0.1,
              text = "Standard deviation of the depth: 10 hPa of weather are 0.1 m.")
          double depthSigma,
      @Variable(
              ifAbsentText = "GLOBAL",
              text =
                  "GLOBAL: z is the altitude; LOCAL_ENU: z is minus the depth; LOCAL_NED: z is the depth.")
          DepthFrame depthFrame) {}

  private final DepthGauge gauge;
  private final DeviceReader<Pressure> reader;
  private final Settings<Tuning> tuning;

  /** Launcher constructor: opens the configured gauge. */
  public DepthSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given gauge, e.g. a simulated one. */
  public DepthSensor(ServiceContext context, DepthGauge gauge) {
    this(context, Optional.of(gauge));
  }

  private DepthSensor(ServiceContext context, Optional<DepthGauge> made) {
    super(context, "DepthSensor", STEPS_PER_S);
    tuning = settings(Tuning.class);
    gauge = Devices.open(DepthGauge.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the depth gauge", gauge, tuning.get().timeout());
  }

  @Override
  protected void step(double nowS) {
    reader
        .next(clock().micros())
        .ifPresent(pressure -> publish(Channels.SENSED_STATE, state(pressure)));
  }

  private StateInformation state(Pressure pressure) {
    Tuning now = tuning.get();
    double gaugePa = pressure.pascals() - now.surfacePressure();
    // p = ρ g h (White, Fluid Mechanics, chapter 2); assumes level: roll and pitch are unknown
    double depthM = gaugePa / (now.waterDensity() * Gravity.STANDARD_MPS2) - now.mountedZ();
    StateInformation state =
        new StateInformation().sensorName(sensorName()).zSigma(now.depthSigma());
    switch (now.depthFrame()) {
      case LOCAL_NED:
        state.referenceFrame(ReferenceFrame.LOCAL_NED).z(depthM);
        break;
      case LOCAL_ENU:
        state.referenceFrame(ReferenceFrame.LOCAL_ENU).z(-depthM);
        break;
      default:
        state.referenceFrame(ReferenceFrame.GLOBAL).z(now.waterLevel() - depthM);
    }
    state.timestamp(pressure.measuredAtMicros());
    return state;
  }

  @Override
  protected void release() {
    gauge.close();
  }
}
