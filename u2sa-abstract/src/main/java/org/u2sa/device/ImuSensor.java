package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.mapping.TrueNorth;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.Orientation;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.SensorParts;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes an IMU's attitude and attitude rates, in GLOBAL, once per reading (thesis 4.1.1), and
 * its gyroscope and accelerometer measurements, in BODY_FRD, as a separate source "… inertial".
 * Heading is omitted while true north is unknown. In: state, for the magnetic declination at the
 * vehicle's position. Out: sensed-state.
 */
public final class ImuSensor extends DeviceSensor<Orientation> {
  private static final SensorKind<Imu> KIND =
      new SensorKind<>(
          "ImuSensor",
          Imu.class,
          new Devices.Usual("IMU", "IMU", "VECTORNAV", "serial:/dev/ttyUSB2?baud=115200"),
          Channels.SENSED_STATE,
          100.0, // Hz
          0.5); // s

  private record Variables(
      @Variable(unit = "rad", min = 0, max = Math.PI, ifAbsent = Math.PI / 180)
          @Description("Standard deviation of roll and pitch, from the data sheet.")
          double attitudeSigma,
      @Variable(unit = "rad", min = 0, max = Math.PI, ifAbsent = Math.PI / 90)
          @Description("Standard deviation of the heading, from the data sheet.")
          double headingSigma,
      @Variable(ifAbsentText = "true")
          @Description(
              "Whether angular rates and specific forces are also published, if the IMU measures both.")
          boolean publishInertial,
      @Variable(unit = "rad/s", min = 0, max = 10, ifAbsent = 0.005)
          @Description("Standard deviation of an angular rate, from the data sheet.")
          double rateSigma,
      @Variable(unit = "m/s^2", min = 0, max = 100, ifAbsent = 0.1)
          @Description("Standard deviation of a specific force, from the data sheet.")
          double forceSigma) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final TrueNorth north = new TrueNorth(this, clock());

  public ImuSensor(ServiceContext context) {
    super(context, KIND);
  }

  public ImuSensor(ServiceContext context, Imu imu) {
    super(context, KIND, imu);
  }

  @Override
  protected Stream<StateInformation> messages(Orientation said) {
    Stream<StateInformation> inertial =
        tuning.get().publishInertial()
            ? said.specificForce().<StateInformation>map(force -> inertial(said, force)).stream()
            : Stream.empty();
    return Stream.concat(inertial, Stream.of(state(said)));
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
    inertial.sensorName(sensorName() + SensorParts.INERTIAL);
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
    return state;
  }
}
