package org.u2sa.trials.run;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.report.score.Surroundings;
import org.u2sa.sim.world.EnvironmentElement;
import org.u2sa.sim.world.MoverElement;
import org.u2sa.sim.world.ScriptedMover;
import org.u2sa.sim.world.World;
import org.u2sa.sim.world.Zone;
import org.u2sa.world.xml.WorldFile;

/** The world of a file, for simulations: objects, environment, movers and zones. */
public final class SimulatedWorld {
  private static final double MAP_STEP_S = 0.5;
  private static final int MAP_STEPS = 600;

  private SimulatedWorld() {}

  /**
   * Adds everything in a file to a world.
   *
   * @param file the world file, to which the paths in it are relative
   * @param seed seed of gusts and waves
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static World read(WorldFile from, Path file, World empty, long seed) {
    World world;
    try {
      world = empty.with(from.objects());
    } catch (IllegalArgumentException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
    Path folder = file.toAbsolutePath().normalize().getParent();
    if (from.environment().isPresent()) {
      world = EnvironmentElement.apply(from.environment().get(), world, folder, seed);
    }
    List<ScriptedMover> movers = new ArrayList<>();
    from.movers()
        .forEach(
            each -> movers.add(MoverElement.read(each.element(), each.object(), empty.plane())));
    List<Zone> zones = new ArrayList<>();
    from.zones()
        .forEach(each -> zones.add(Zone.read(each.element(), each.object(), empty.plane())));
    return world.withMovers(movers).withZones(zones);
  }

  /**
   * Objects, movers and zones, for the map and the summary: a mover as a sphere of its horizontal
   * radius, and, if it is upright and round, with its shape; zones only if judged or keep-out.
   *
   * @param limitS longest duration of the run [s]
   */
  public static Surroundings surroundings(World world, double limitS) {
    double step = Math.max(MAP_STEP_S, limitS / MAP_STEPS);
    List<ObjectDescription> all = new ArrayList<>(world.obstacles());
    world.movers().forEach(mover -> all.add(sphere(mover, step)));
    List<Surroundings.Area> areas =
        world.zones().stream()
            .filter(zone -> zone.kind() != Zone.Kind.PATCH)
            .map(SimulatedWorld::area)
            .toList();
    Map<String, ObjectDescription> upright =
        world.movers().stream()
            .map(ScriptedMover::object)
            .filter(Cylinder.class::isInstance)
            .collect(Collectors.toMap(ObjectDescription::uid, shape -> shape));
    return new Surroundings(all, 0.0, areas, upright);
  }

  private static Surroundings.Area area(Zone zone) {
    Polygon outline = new Polygon().points(zone.corners());
    outline.uid(zone.name()).referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(0.0).z(0.0);
    outline.freeze();
    return new Surroundings.Area(outline, zone.kind() == Zone.Kind.KEEP_OUT);
  }

  private static MovingSphere sphere(ScriptedMover mover, double stepS) {
    List<Point> way = new ArrayList<>();
    for (int i = 1; i <= MAP_STEPS; i++) {
      way.add(mover.at(i * stepS).position());
    }
    Point start = mover.at(0.0).position();
    MovingSphere sphere = new MovingSphere().radius(mover.radiusM());
    sphere.uid(mover.uid()).objectType(mover.objectType());
    if (!mover.isRound()) {
      sphere.level(ObjectLevel.HINDRANCE); // inside the circle is not inside it: contacts tell
    }
    sphere.referenceFrame(ReferenceFrame.LOCAL_ENU);
    sphere.x(start.x()).y(start.y()).z(start.z());
    sphere.timeStep(stepS).trajectory(way);
    sphere.freeze();
    return sphere;
  }
}
