package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.Orientation;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes an IMU's attitude and attitude rates, in GLOBAL, once per reading (thesis 4.1.1), and
 * its gyroscope and accelerometer measurements, in BODY_FRD, as a separate source "… inertial".
 * Heading is omitted while true north is unknown. In: state, for the magnetic declination at the
 * vehicle's position. Out: sensed-state.
 */
public final class ImuSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 100.0;
  private static final String INERTIAL = " inertial"; // suffix of the sensor's name

  private static final Devices.Usual USUAL =
      new Devices.Usual("IMU", "IMU", "VECTORNAV", "serial:/dev/ttyUSB2?baud=115200");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.05,
              max = 60,
              ifAbsent = 0.5,
              text = "Time without a readable message after which the IMU counts as silent.")
          double timeout,
      @Variable(
              unit = "rad",
              min = 0,
              max = Math.PI,
              ifAbsent = Math.PI / 180,
              text = "Standard deviation of roll and pitch, from the data sheet.")
          double attitudeSigma,
      @Variable(
              unit = "rad",
              min = 0,
              max = Math.PI,
              ifAbsent = Math.PI / 90,
              text = "Standard deviation of the heading, from the data sheet.")
          double headingSigma,
      @Variable(
              ifAbsentText = "true",
              text =
                  "Whether angular rates and specific force are published, too, if the IMU says both.")
          boolean publishInertial,
      @Variable(
              unit = "rad/s",
              min = 0,
              max = 10,
              ifAbsent = 0.005,
              text = "Standard deviation of an angular rate, from the data sheet.")
          double rateSigma,
      @Variable(
              unit = "m/s^2",
              min = 0,
              max = 100,
              ifAbsent = 0.1,
              text = "Standard deviation of a specific force, from the data sheet.")
          double forceSigma) {}

  private final Imu imu;
  private final DeviceReader<Orientation> reader;
  private final TrueNorth north;
  private final Settings<Tuning> tuning;

  /** Launcher constructor: opens the configured IMU. */
  public ImuSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given IMU, e.g. the phone's or a simulated one. */
  public ImuSensor(ServiceContext context, Imu imu) {
    this(context, Optional.of(imu));
  }

  private ImuSensor(ServiceContext context, Optional<Imu> made) {
    super(context, "ImuSensor", STEPS_PER_S);
    tuning = settings(Tuning.class);
    north = new TrueNorth(this);
    registerSubscriber(Channels.STATE);
    imu = Devices.open(Imu.class, USUAL, context, made);
    reader = new DeviceReader<>(this, "the IMU", imu, tuning.get().timeout());
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
    reader.next(clock().micros()).ifPresent(this::publish);
  }

  private void publish(Orientation said) {
    if (tuning.get().publishInertial()) {
      said.specificForce()
          .ifPresent(force -> publish(Channels.SENSED_STATE, inertial(said, force)));
    }
    publish(Channels.SENSED_STATE, state(said));
  }

  private InertialMeasurement inertial(Orientation said, Point force) {
    InertialMeasurement inertial =
        new InertialMeasurement()
            .rollRate(said.xRateRadPerS())
            .pitchRate(said.yRateRadPerS())
            .yawRate(said.zRateRadPerS())
            .angularRateSigma(tuning.get().rateSigma())
            .specificForceX(force.x())
            .specificForceY(force.y())
            .specificForceZ(force.z())
            .specificForceSigma(tuning.get().forceSigma());
    inertial.sensorName(sensorName() + INERTIAL);
    inertial.timestamp(said.measuredAtMicros());
    return inertial;
  }

  private StateInformation state(Orientation said) {
    double attitudeSigmaRad = tuning.get().attitudeSigma();
    double headingSigmaRad = tuning.get().headingSigma();
    StateInformation state =
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.GLOBAL)
            .phi(said.rollRad())
            .theta(said.pitchRad())
            .phiSigma(attitudeSigmaRad)
            .thetaSigma(attitudeSigmaRad);
    said.eulerRates()
        .ifPresent(rates -> state.phiDot(rates.x()).thetaDot(rates.y()).psiDot(rates.z()));
    north.of(said.heading(), 0.0).ifPresent(psi -> state.psi(psi).psiSigma(headingSigmaRad));
    state.timestamp(said.measuredAtMicros());
    return state;
  }

  @Override
  protected void release() {
    imu.close();
  }
}
