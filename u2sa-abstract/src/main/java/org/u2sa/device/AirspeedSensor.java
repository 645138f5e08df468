package org.u2sa.device;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.PitotTube;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the true airspeed from a pitot tube's pressure, as the vehicle's forward speed through
 * the fluid, once per reading. In: state, whose altitude gives the standard atmosphere's pressure
 * and temperature if the device does not measure them. Out: sensed-state.
 */
public final class AirspeedSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0;
  private static final double HEAT_RATIO = 1.4;
  private static final double GAS_CONSTANT = 287.05287; // dry air [J/(kg K)]

  private static final Devices.Usual USUAL =
      new Devices.Usual(
          "pitot tube", "PITOT TUBE", "IIO", "/sys/bus/iio/devices/iio:device0/in_pressure_input");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.05,
              max = 60,
              ifAbsent = 1,
              text =
                  "Time without a readable pressure after which the pitot tube counts as silent.")
          double timeout,
      @Variable(
              unit = "Pa",
              min = -1000,
              max = 1000,
              ifAbsent = 0,
              text = "Pressure that the sensor shows in still air; subtracted.")
          double zeroPressure,
      @Variable(
              min = 0.5,
              max = 2,
              ifAbsent = 1,
              text = "Factor of the pressure difference, for the error of the tube's position.")
          double pressureFactor,
      @Variable(
              unit = "Pa",
              min = 0.01,
              max = 1000,
              ifAbsent = 5,
              text = "Standard deviation of the pressure difference.")
          double pressureSigma) {}

  private final PitotTube tube;
  private final DeviceReader<PitotTube.Impact> reader;
  private final Settings<Tuning> tuning;
  private double altitudeM; // latest; sea level until known

  /** Launcher constructor: opens the configured pitot tube. */
  public AirspeedSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given pitot tube, e.g. a simulated one. */
  public AirspeedSensor(ServiceContext context, PitotTube tube) {
    this(context, Optional.of(tube));
  }

  private AirspeedSensor(ServiceContext context, Optional<PitotTube> made) {
    super(context, "AirspeedSensor", STEPS_PER_S);
    tuning = settings(Tuning.class);
    registerSubscriber(Channels.STATE);
    tube = Devices.open(PitotTube.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the pitot tube", tube, tuning.get().timeout());
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof StateInformation state) {
      if (state.referenceFrame().isEarth()) {
        altitudeM = state.z().orElse(altitudeM);
      }
    } else {
      unexpected(data);
    }
  }

  @Override
  protected void step(double nowS) {
    reader
        .next(clock().micros())
        .ifPresent(impact -> publish(Channels.SENSED_STATE, state(impact)));
  }

  private StateInformation state(PitotTube.Impact impact) {
    Tuning now = tuning.get();
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
    StateInformation state =
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.GLOBAL)
            .fluidxDot(speedMps)
            .fluidxDotSigma(sigmaMps);
    state.timestamp(impact.measuredAtMicros());
    return state;
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

  @Override
  protected void release() {
    tube.close();
  }
}
