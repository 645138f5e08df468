package org.u2sa.device;

import java.util.Locale;
import java.util.stream.Stream;
import org.u2sa.device.port.DepthGauge;
import org.u2sa.device.port.Pressure;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.device.pressure.PressureZero;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Publishes the depth of a vehicle, once per reading of an underwater pressure sensor: as altitude
 * in GLOBAL, or as z of a local frame. Out: sensed-state.
 *
 * <p>With ZERO TIME, the sensor's constant error is measured first, while the vehicle floats. A
 * service that starts under water detects by the pressure that the vehicle is not afloat.
 */
public final class DepthSensor extends DeviceSensor<Pressure> {
  private static final SensorKind<DepthGauge> KIND =
      new SensorKind<>(
          "DepthSensor",
          DepthGauge.class,
          new Devices.Usual(
              "depth gauge",
              "DEPTH GAUGE",
              "IIO",
              "/sys/bus/iio/devices/iio:device0/in_pressure_input"),
          Channels.SENSED_STATE,
          50.0, // Hz
          1.0); // s

  /** Frame of the published depth. */
  enum DepthFrame {
    GLOBAL,
    LOCAL_ENU,
    LOCAL_NED
  }

  private record Variables(
      @Variable(unit = "kg/m^3", min = 900, max = 1300, ifAbsent = 1025)
          @Description("Water density: 1025 in the sea, 998 in a pool.")
          double waterDensity,
      @Variable(unit = "Pa", min = 0, max = 110_000, ifAbsent = PressureAltitude.SEA_LEVEL_PA)
          @Description("Air pressure at the surface; 0 for a gauge-pressure sensor.")
          double surfacePressure,
      @Variable(unit = "m", min = -500, max = 9000, ifAbsent = 0)
          @Description("GLOBAL: altitude of the water surface above mean sea level.")
          double waterLevel,
      @Variable(name = "MOUNTED Z", unit = "m", min = -100, max = 100, ifAbsent = 0)
          @Description("Position of the sensor on the vehicle, down.")
          double mountedZ,
      @Variable(unit = "m", min = 0.001, max = 100, ifAbsent = 0.1)
          @Description(
              "Standard deviation of the depth; a change of 10 hPa in air pressure shifts it by 0.1 m.")
          double depthSigma,
      @Variable(ifAbsentText = "GLOBAL")
          @Description(
              "GLOBAL: z is the altitude; LOCAL_ENU: z is minus the depth; LOCAL_NED: z is the depth.")
          DepthFrame depthFrame,
      @Variable(unit = "s", min = 0, max = 60, ifAbsent = 0)
          @Description(
              "Time after the start for which the vehicle floats at FLOATING DEPTH; the sensor's mean error during this time is subtracted from later readings, and no depth is published until it ends. 0: no correction.")
          double zeroTime,
      @Variable(unit = "m", min = -100, max = 100, ifAbsent = 0)
          @Description("Depth of the vehicle's reference point while it floats.")
          double floatingDepth,
      @Variable(unit = "Pa", min = 0, max = 1_000_000, ifAbsent = 7_000)
          @Description(
              "Maximum error to correct. A larger one at the start means that the vehicle is not afloat.")
          double maxError) {}

  private static final String ZERO = "ZERO";

  private final Settings<Variables> tuning = settings(Variables.class);
  private final PressureZero zero = new PressureZero();

  public DepthSensor(ServiceContext context) {
    super(context, KIND);
  }

  public DepthSensor(ServiceContext context, DepthGauge gauge) {
    super(context, KIND, gauge);
  }

  @Override
  protected Stream<StateInformation> messages(Pressure pressure) {
    Variables now = tuning.get();
    double gaugePa = pressure.pascals() - now.surfacePressure();
    // p = ρ g h (White, Fluid Mechanics, chapter 2); assumes level: roll and pitch are unknown
    double pascalsPerM = now.waterDensity() * Gravity.STANDARD_MPS2;
    if (zero.errorPa().isEmpty()) {
      zero(
          pressure.measuredAtMicros(),
          gaugePa - (now.floatingDepth() + now.mountedZ()) * pascalsPerM);
    }
    if (zero.errorPa().isEmpty()) {
      return Stream.empty();
    }
    double depthM = (gaugePa - zero.errorPa().getAsDouble()) / pascalsPerM - now.mountedZ();
    StateInformation state =
        new StateInformation().sensorName(sensorName()).zSigma(now.depthSigma());
    switch (now.depthFrame()) {
      case LOCAL_NED -> state.referenceFrame(ReferenceFrame.LOCAL_NED).z(depthM);
      case LOCAL_ENU -> state.referenceFrame(ReferenceFrame.LOCAL_ENU).z(-depthM);
      case GLOBAL -> state.referenceFrame(ReferenceFrame.GLOBAL).z(now.waterLevel() - depthM);
    }
    return Stream.of(state);
  }

  private void zero(long measuredMicros, double offPa) {
    Variables now = tuning.get();
    if (now.zeroTime() == 0.0) {
      zero.is(0.0);
    } else if (Math.abs(offPa) > now.maxError()) {
      log(
          LogLevelEnum.WARN,
          String.format(Locale.ROOT, "not afloat, or off by %.0f Pa: no correction", offPa));
      zero.is(0.0);
    } else {
      zero.take(measuredMicros, offPa, now.zeroTime());
      zero.errorPa()
          .ifPresent(
              pascals ->
                  log(String.format(Locale.ROOT, "afloat: gauge error of %.0f Pa", pascals)));
    }
    if (zero.errorPa().isPresent()) {
      remember(); // restarted under water, it must not take the depth for its error
    }
  }

  @Override
  protected void handOver(HandOver state) {
    zero.errorPa().ifPresent(pascals -> state.number(ZERO, pascals));
  }

  @Override
  protected void takeOver(HandOver state) {
    state.number(ZERO).ifPresent(zero::is);
  }
}
