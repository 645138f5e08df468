package org.u2sa.device.payload;

import java.util.stream.Stream;
import org.u2sa.device.DeviceSensor;
import org.u2sa.device.Devices;
import org.u2sa.device.MountingPose;
import org.u2sa.device.SensorKind;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the acceleration that a measured thrust gives the vehicle, along the thruster's axis,
 * in BODY, once per reading (thesis 4.2.1.1). Out: sensed-state.
 *
 * <p>The load cell measures neither drag nor gravity nor other thrusters: OTHER FORCES SIGMA adds
 * them to the standard deviation.
 */
public final class ThrustSensor extends DeviceSensor<LoadCell.Load> {
  private static final double ALONG = 1.0e-3; // smaller components of the axis count as 0

  private static final StateField[] ACCELERATION = {
    StateField.X_DOUBLE_DOT, StateField.Y_DOUBLE_DOT, StateField.Z_DOUBLE_DOT
  };
  private static final StateField[] SIGMA = {
    StateField.X_DOUBLE_DOT_SIGMA, StateField.Y_DOUBLE_DOT_SIGMA, StateField.Z_DOUBLE_DOT_SIGMA
  };
  private static final SensorKind<LoadCell> KIND =
      new SensorKind<>(
          "ThrustSensor",
          LoadCell.class,
          new Devices.Usual(
              "load cell", "LOAD CELL", "IIO", "/sys/bus/iio/devices/iio:device0/in_voltage0_raw"),
          Channels.SENSED_STATE,
          20.0, // Hz
          2.0); // s

  private record Variables(
      @Variable(unit = "kg", min = 0.01, max = 1e7)
          @Description("Mass of the vehicle; on and under water including the added mass in surge.")
          double mass,
      @Variable(unit = "N", min = 1e-6, max = 1e7, ifAbsent = 1)
          @Description("Standard deviation of the thrust, from the calibration.")
          double thrustSigma,
      @Variable(unit = "m/s^2", min = 1e-6, max = 1_000, ifAbsent = 0.5)
          @Description(
              "Standard deviation of the acceleration from forces that the cell does not measure: drag, gravity, other thrusters.")
          double otherForcesSigma) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final MountingPose mounted = settings(MountingPose.class).get();

  public ThrustSensor(ServiceContext context) {
    super(context, KIND);
  }

  public ThrustSensor(ServiceContext context, LoadCell loadCell) {
    super(context, KIND, loadCell);
  }

  @Override
  protected Stream<StateInformation> messages(LoadCell.Load load) {
    Variables now = tuning.get();
    Point place = Point.of(mounted.x(), mounted.y(), mounted.z());
    Point axis = mounted.turn().toBody(Point.of(1.0, 0.0, 0.0)).minus(place);
    double[] along = {axis.x(), axis.y(), axis.z()};
    StateInformation state =
        new StateInformation().sensorName(sensorName()).referenceFrame(ReferenceFrame.BODY);
    for (int i = 0; i < along.length; i++) {
      if (Math.abs(along[i]) >= ALONG) {
        state.number(ACCELERATION[i], along[i] * load.newtons() / now.mass());
        double own = along[i] * now.thrustSigma() / now.mass();
        state.number(SIGMA[i], Math.hypot(own, now.otherForcesSigma()));
      }
    }
    return Stream.of(state);
  }
}
