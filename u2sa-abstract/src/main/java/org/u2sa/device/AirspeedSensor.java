package org.u2sa.device;

import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.u2sa.device.port.PitotTube;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the true airspeed from a pitot tube's pressure, as the vehicle's forward speed through
 * the fluid, once per reading. In: state, whose altitude gives the standard atmosphere's pressure
 * and temperature if the device does not measure them. Out: sensed-state.
 */
public final class AirspeedSensor extends DeviceSensor<PitotTube.Impact> {
  private static final double HEAT_RATIO = 1.4;
  private static final double GAS_CONSTANT = 287.05287; // dry air [J/(kg K)]

  private static final SensorKind<PitotTube> KIND =
      new SensorKind<>(
          "AirspeedSensor",
          PitotTube.class,
          new Devices.Usual(
              "pitot tube",
              "PITOT TUBE",
              "IIO",
              "/sys/bus/iio/devices/iio:device0/in_pressure_input"),
          Channels.SENSED_STATE,
          50.0, // Hz
          1.0); // s

  private record Variables(
      @Variable(unit = "Pa", min = -1000, max = 1000, ifAbsent = 0)
          @Description("Reading in still air, which is subtracted.")
          double zeroPressure,
      @Variable(min = 0.5, max = 2, ifAbsent = 1)
          @Description("Factor on the pressure difference that corrects the tube's position error.")
          double pressureFactor,
      @Variable(unit = "Pa", min = 0.01, max = 1000, ifAbsent = 5)
          @Description("Standard deviation of the pressure difference.")
          double pressureSigma) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final OwnAltitude altitude = new OwnAltitude(this);

  public AirspeedSensor(ServiceContext context) {
    super(context, KIND);
  }

  public AirspeedSensor(ServiceContext context, PitotTube tube) {
    super(context, KIND, tube);
  }

  @Override
  protected Stream<StateInformation> messages(PitotTube.Impact impact) {
    Variables now = tuning.get();
    double altitudeM = altitude.metres();
    double staticPa =
        or(impact.staticPa(), PressureAltitude.pascalsAt(altitudeM, PressureAltitude.SEA_LEVEL_PA));
    double temperatureK = or(impact.temperatureK(), PressureAltitude.temperatureAt(altitudeM));
    double impactPa = now.pressureFactor() * (impact.differentialPa() - now.zeroPressure());
    double speedMps = trueAirspeedMps(Math.max(0.0, impactPa), staticPa, temperatureK);
    double densityKgPerM3 = staticPa / (GAS_CONSTANT * temperatureK);
    // q = ½ρV²: σ_V = σ_q / (ρV); near rest bounded by the speed that corresponds to σ_q
    double sigmaPa = now.pressureFactor() * now.pressureSigma();
    double noiseMps = Math.sqrt(2.0 * sigmaPa / densityKgPerM3);
    double sigmaMps = sigmaPa / (densityKgPerM3 * Math.max(speedMps, noiseMps));
    return Stream.of(
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.GLOBAL)
            .fluidxDot(speedMps)
            .fluidxDotSigma(sigmaMps));
  }

  private static double or(OptionalDouble measured, double otherwise) {
    return measured.isPresent() && measured.getAsDouble() > 0.0
        ? measured.getAsDouble()
        : otherwise;
  }

  /**
   * Subsonic true airspeed for an impact pressure (Gracey, NASA RP-1046, chapter 3) at the given
   * temperature.
   */
  private static double trueAirspeedMps(double impactPa, double staticPa, double temperatureK) {
    double ratio = Math.pow(impactPa / staticPa + 1.0, (HEAT_RATIO - 1.0) / HEAT_RATIO);
    double mach = Math.sqrt(2.0 / (HEAT_RATIO - 1.0) * (ratio - 1.0));
    return mach * Math.sqrt(HEAT_RATIO * GAS_CONSTANT * temperatureK);
  }
}
