package org.u2sa.device;

import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes an IMU's attitude and its rates, in GLOBAL, once for each reading (thesis 4.1.1).
 * Heading is left out while true north is not known. In: state, for the magnetic declination where
 * the vehicle is. Out: sensed-state.
 */
public final class ImuSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 100.0;

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB2?baud=115200")
          .describedAs("Address of the IMU, as its driver takes it (docs/drivers/links.md).");

  static final VariableDeclaration<String> IMU =
      VariableDeclaration.text("IMU")
          .ifAbsent("VECTORNAV")
          .describedAs("Kind of IMU: the name of a driver.");

  static final VariableDeclaration<Double> TIMEOUT =
      VariableDeclaration.number("TIMEOUT", "s")
          .range(Range.of(0.05, 60.0))
          .ifAbsent(0.5)
          .describedAs("Time without a readable message after which the IMU counts as silent.");

  static final VariableDeclaration<Double> ATTITUDE_SIGMA =
      VariableDeclaration.number("ATTITUDE SIGMA", "rad")
          .range(Range.of(0.0, Math.PI))
          .ifAbsent(Math.toRadians(1.0))
          .describedAs("Standard deviation of roll and pitch, from the data sheet.");

  static final VariableDeclaration<Double> HEADING_SIGMA =
      VariableDeclaration.number("HEADING SIGMA", "rad")
          .range(Range.of(0.0, Math.PI))
          .ifAbsent(Math.toRadians(2.0))
          .describedAs("Standard deviation of the heading, from the data sheet.");

  private final Imu imu;
  private final DeviceReader<Orientation> reader;
  private final TrueNorth north;
  private final double attitudeSigmaRad;
  private final double headingSigmaRad;

  /** Called by the launcher: the IMU is the one that the configuration names. */
  public ImuSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** With an IMU that the host made: the phone's, a simulated one. */
  public ImuSensor(ServiceContext context, Imu imu) {
    this(context, Optional.of(imu));
  }

  private ImuSensor(ServiceContext context, Optional<Imu> made) {
    super(context, "ImuSensor", STEPS_PER_S);
    getVariable(CONNECTION);
    double timeoutS = getVariable(TIMEOUT);
    attitudeSigmaRad = getVariable(ATTITUDE_SIGMA);
    headingSigmaRad = getVariable(HEADING_SIGMA);
    north = new TrueNorth(this);
    registerSubscriber(Channels.STATE);
    imu = Devices.open(Imu.class, IMU, context, made);
    reader = new DeviceReader<>(this, "the IMU", imu, timeoutS);
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof StateInformation state) {
      north.at(state, clock().micros());
    } else {
      unexpected(data);
    }
  }

  @Override
  protected void step(double nowS) {
    reader
        .next(clock().micros())
        .ifPresent(orientation -> publish(Channels.SENSED_STATE, state(orientation)));
  }

  private StateInformation state(Orientation said) {
    StateInformation state =
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.GLOBAL)
            .phi(said.rollRad())
            .theta(said.pitchRad())
            .phiSigma(attitudeSigmaRad)
            .thetaSigma(attitudeSigmaRad)
            .phiDot(said.rollRateRadPerS())
            .thetaDot(said.pitchRateRadPerS())
            .psiDot(said.headingRateRadPerS());
    north.of(said.heading(), 0.0).ifPresent(psi -> state.psi(psi).psiSigma(headingSigmaRad));
    state.timestamp(said.measuredAtMicros());
    return state;
  }

  @Override
  protected void release() {
    imu.close();
  }
}
