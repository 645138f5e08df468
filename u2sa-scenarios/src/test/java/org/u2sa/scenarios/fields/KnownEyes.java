package org.u2sa.scenarios.fields;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.World;
import org.u2sa.testkit.ServiceKit;

/** A true map of what was in sight, and traffic with its true velocity: the planner's own test. */
final class KnownEyes implements RoverEyes {
  private static final int SCAN_EVERY = 4;

  private final RandomField field;
  private final World world;
  private final ServiceKit kit;
  private final LidarMap map;
  private int step;

  KnownEyes(RandomField field, World world, ServiceKit kit) {
    this.field = field;
    this.world = world;
    this.kit = kit;
    map = new LidarMap(field.kind.sideM(), RANGE_M);
  }

  @Override
  public void look(VehicleTruth truth) {
    if (step++ % SCAN_EVERY == 0) {
      map.scan(world, truth.position().x(), truth.position().y());
      kit.publish(Channels.GRID, map.message());
      kit.publish(Channels.OBJECTS, traffic(truth.position().x(), truth.position().y()));
    }
  }

  private ObjectList traffic(double east, double north) {
    List<ObjectDescription> seen = new ArrayList<>();
    double now = kit.nowS();
    for (int i = 0; i < field.traffic.size(); i++) {
      RandomField.Traffic other = field.traffic.get(i);
      if (Math.hypot(other.eastM(now) - east, other.northM(now) - north) < RANGE_M) {
        Circle circle =
            new Circle()
                .radius(other.radiusM)
                .uid("T" + i)
                .referenceFrame(ReferenceFrame.LOCAL_ENU)
                .x(other.eastM(now))
                .y(other.northM(now));
        circle.timestamp(kit.clock().micros());
        circle.motion().velocity(Point.of(other.eastMps(now), other.northMps(now), 0.0));
        seen.add(circle);
      }
    }
    return new ObjectList().objects(seen);
  }
}
