package org.u2sa.scenarios.roboboat.subvehicle;

import java.util.List;
import java.util.stream.Stream;
import org.u2sa.device.DeviceSensor;
import org.u2sa.device.Devices;
import org.u2sa.device.SensorKind;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Puck;
import org.u2sa.service.ServiceContext;

/**
 * Detects by the gripper's load cell whether it holds a puck. The vehicle has no World Modeler, so
 * the sensor publishes the complete list of objects: a puck at the vehicle's position in BODY, or
 * none. Out: objects.
 */
public final class GripperSensor extends DeviceSensor<LoadCell.Load> {
  private static final String HELD = "held"; // name of an object in the gripper

  private static final SensorKind<LoadCell> KIND =
      new SensorKind<>(
          "GripperSensor",
          LoadCell.class,
          new Devices.Usual(
              "load cell", "LOAD CELL", "IIO", "/sys/bus/iio/devices/iio:device0/in_voltage0_raw"),
          Channels.OBJECTS,
          10.0, // Hz
          2.0); // s

  private record Variables(
      @Variable(unit = "N", min = 0.01, max = 1_000, ifAbsent = 0.8)
          @Description(
              "Load above which the gripper is considered to hold an object: about half the object's weight.")
          double heldLoad,
      @Variable(unit = "s", min = 0.01, max = 60, ifAbsent = 0.5)
          @Description("Time constant of the smoothed load.")
          double loadTime) {}

  private final Variables variables = settings(Variables.class).get();
  private double smoothedN;
  private long beforeMicros = Long.MIN_VALUE;

  public GripperSensor(ServiceContext context) {
    super(context, KIND);
  }

  public GripperSensor(ServiceContext context, LoadCell loadCell) {
    super(context, KIND, loadCell);
  }

  @Override
  protected Stream<ObjectList> messages(LoadCell.Load load) {
    long micros = load.measuredAtMicros();
    double share =
        beforeMicros == Long.MIN_VALUE
            ? 1.0
            : -Math.expm1((beforeMicros - micros) * 1e-6 / variables.loadTime());
    smoothedN += share * (load.newtons() - smoothedN);
    beforeMicros = micros;
    return Stream.of(
        new ObjectList().objects(smoothedN < variables.heldLoad() ? List.of() : List.of(held())));
  }

  /** Whether one of its object lists contains a gripped object. */
  static boolean isHolding(List<ObjectDescription> objects) {
    return objects.stream().anyMatch(each -> each.uid().equals(HELD));
  }

  private static ObjectDescription held() {
    Puck puck = new Puck().radius(0.0381).height(0.0254);
    puck.uid(HELD).objectType("puck").level(ObjectLevel.HINDRANCE);
    puck.referenceFrame(ReferenceFrame.BODY).x(0.0).y(0.0).z(0.0);
    return puck;
  }
}
