package org.u2sa.world;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.testkit.ServiceKit;

/** A World Modeler in the test kit, what it is shown and what it publishes. */
public final class ModelledWorld implements AutoCloseable {
  public final ServiceKit kit = new ServiceKit();

  @Override
  public void close() {
    kit.close();
  }

  public static StateInformation local(double x, double y, double psi) {
    return new StateInformation()
        .sensorName("StateEstimator")
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(x)
        .y(y)
        .psi(psi);
  }

  static ObjectDescription seen(String uid, double ahead, double left) {
    return new Circle()
        .radius(0.2)
        .uid(uid)
        .objectType("barrel")
        .referenceFrame(ReferenceFrame.BODY)
        .x(ahead)
        .y(left)
        .sensorName("Camera");
  }

  public static RangeScan wallAhead(double range) {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < 21; i++) {
      ranges.add(OptionalDouble.of(range));
    }
    return new RangeScan().sensorName("Lidar").maxRange(10.0).beams(-0.1, 0.01, ranges);
  }

  public List<ObjectDescription> objects() {
    return kit.latest(Channels.OBJECTS).orElseThrow().objects();
  }

  OccupancyGrid grid() {
    return kit.latest(Channels.GRID).orElseThrow();
  }

  /** A tenth of a second, with a state and what was seen at its beginning. */
  void tick(StateInformation state, ObjectDescription... seen) {
    kit.send(Channels.STATE, state);
    for (ObjectDescription each : seen) {
      kit.send(Channels.SENSED_OBJECTS, each);
    }
    kit.settle();
    kit.advance(0.1);
  }

  String remarks() {
    return String.join("; ", kit.latest(Channels.HEALTH).orElseThrow().remarks());
  }

  void change(String variable, String value) {
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange().serviceName("WorldModeler").variableName(variable).value(value));
  }

  void stand(int ticks) {
    for (int i = 0; i < ticks; i++) {
      tick(local(0.0, 0.0, 0.0));
    }
  }
}
