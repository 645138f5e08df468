package org.u2sa.sim.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.atmosphere.WindField;

/**
 * The environment of a run: ground, obstacles, wind and water. Positions are east, north, up [m] on
 * a plane tangent to the earth at the origin. Immutable and thread-safe; changes create a copy.
 */
public final class World {
  private final LocalPlane plane;
  private final Terrain terrain;
  private final Surface surface;
  private final Wind wind;
  private final Optional<Water> water;
  private final List<ObjectDescription> obstacles;
  private final Optional<ObstacleTree> tree;
  private final Script script;

  /** Content of a world file other than obstacles. */
  private record Script(List<ScriptedMover> movers, List<Zone> zones, Optional<Sunlight> light) {}

  /**
   * Nearest hit of a ray.
   *
   * @param distanceM distance from the ray's origin [m]
   * @param at position: east, north, up [m]
   * @param object object hit; empty for the ground
   */
  public record Hit(double distanceM, Point at, Optional<ObjectDescription> object) {}

  private World(
      LocalPlane plane,
      Terrain terrain,
      Surface surface,
      Wind wind,
      Optional<Water> water,
      List<ObjectDescription> obstacles,
      Optional<ObstacleTree> tree,
      Script script) {
    this.plane = plane;
    this.terrain = Objects.requireNonNull(terrain, "terrain");
    this.surface = Objects.requireNonNull(surface, "surface");
    this.wind = Objects.requireNonNull(wind, "wind");
    this.water = water;
    this.obstacles = obstacles;
    this.tree = tree;
    this.script = script;
  }

  /** A level lawn at the origin's altitude, without obstacles or wind. */
  public static World at(Geodetic origin) {
    return new World(
        new LocalPlane(origin),
        Terrain.flat(),
        Surface.lawn(),
        Wind.calm(),
        Optional.empty(),
        List.of(),
        Optional.empty(),
        new Script(List.of(), List.of(), Optional.empty()));
  }

  /** Copy with a different terrain. */
  public World with(Terrain newTerrain) {
    return new World(plane, newTerrain, surface, wind, water, obstacles, tree, script);
  }

  /** Copy with a different surface. */
  public World with(Surface newSurface) {
    return new World(plane, terrain, newSurface, wind, water, obstacles, tree, script);
  }

  /** Copy with a different wind. */
  public World with(Wind newWind) {
    return new World(plane, terrain, surface, newWind, water, obstacles, tree, script);
  }

  /** Copy with water. */
  public World with(Water newWater) {
    return new World(plane, terrain, surface, wind, Optional.of(newWater), obstacles, tree, script);
  }

  /**
   * Copy with these obstacles. Their frame is LOCAL_ENU or LOCAL_NED about the world's origin, or
   * GLOBAL or UTM, where z is the altitude. Flat shapes keep their height: rays from above hit
   * discs and rectangles, but never lines or points.
   *
   * @throws IllegalArgumentException if one has a vehicle frame or an unsupported shape
   */
  public World with(List<? extends ObjectDescription> newObstacles) {
    return new World(
        plane,
        terrain,
        surface,
        wind,
        water,
        List.copyOf(newObstacles),
        tree(newObstacles),
        script);
  }

  private Optional<ObstacleTree> tree(List<? extends ObjectDescription> objects) {
    List<ObstacleTree.Leaf> leaves = new ArrayList<>();
    for (ObjectDescription object : objects) {
      Obstacle shape = Obstacle.of(object, plane);
      leaves.add(new ObstacleTree.Leaf(object, shape, shape.bounds()));
    }
    return leaves.isEmpty() ? Optional.empty() : Optional.of(ObstacleTree.of(leaves));
  }

  private World with(Surface newSurface, Script newScript) {
    return new World(plane, terrain, newSurface, wind, water, obstacles, tree, newScript);
  }

  /** Copy with movers, which {@link #when} positions. */
  public World withMovers(List<ScriptedMover> movers) {
    return with(surface, new Script(List.copyOf(movers), script.zones, script.light));
  }

  /** Copy with zones, whose surfaces override the world's. */
  public World withZones(List<Zone> zones) {
    return with(
        Zone.patched(surface, zones), new Script(script.movers, List.copyOf(zones), script.light));
  }

  /** Copy in the light of the sun. */
  public World with(Sunlight light) {
    return with(surface, new Script(script.movers, script.zones, Optional.of(light)));
  }

  /** The world at a time since the run's start [s], with its movers as obstacles. */
  public World when(double timeS) {
    if (script.movers.isEmpty()) {
      return this;
    }
    List<ObjectDescription> moved = new ArrayList<>(script.movers.size());
    script.movers.forEach(mover -> moved.add(mover.objectAt(timeS, water.orElse(null))));
    Optional<ObstacleTree> around = tree(moved);
    List<ObjectDescription> all = new ArrayList<>(obstacles);
    all.addAll(moved);
    return new World(
        plane,
        terrain,
        surface,
        wind,
        water,
        Collections.unmodifiableList(all),
        tree.isEmpty() ? around : Optional.of(tree.get().and(around.orElseThrow())),
        new Script(List.of(), script.zones, script.light));
  }

  public List<ScriptedMover> movers() {
    return script.movers;
  }

  /** Named areas. */
  public List<Zone> zones() {
    return script.zones;
  }

  /** The sun; empty: even light without shadows. */
  public Optional<Sunlight> light() {
    return script.light;
  }

  /** Location on earth. */
  public LocalPlane plane() {
    return plane;
  }

  public Terrain terrain() {
    return terrain;
  }

  /** Driving surface. */
  public Surface surface() {
    return surface;
  }

  public Wind wind() {
    return wind;
  }

  /** The wind for a vehicle with this span [m]. */
  public WindField windAround(double spanM) {
    return new WindField(wind, spanM);
  }

  public Optional<Water> water() {
    return water;
  }

  public List<ObjectDescription> obstacles() {
    return obstacles;
  }

  /**
   * Elevation of the ground above mean sea level [m] at a WGS-84 position [°].
   *
   * @throws IllegalStateException if the terrain has no finite height there
   */
  public double elevationM(double longitudeDeg, double latitudeDeg) {
    double origin = plane.origin().altitudeM();
    if (terrain == Terrain.flat()) {
      return origin; // far beyond the flight range
    }
    Point on = plane.point(new Geodetic(longitudeDeg, latitudeDeg, origin));
    double elevation = origin + terrain.heightM(on.x(), on.y());
    if (!Double.isFinite(elevation)) {
      throw new IllegalStateException(
          String.format(
              "terrain elevation at %s°, %s°: %s is not a number of metres",
              latitudeDeg, longitudeDeg, elevation));
    }
    return elevation;
  }

  /**
   * Slope of the ground toward east and north [1] at a WGS-84 position [°], in the axes of the
   * origin.
   */
  public Point slope(double longitudeDeg, double latitudeDeg) {
    if (terrain == Terrain.flat()) {
      return Point.ORIGIN;
    }
    Point on = plane.point(new Geodetic(longitudeDeg, latitudeDeg, plane.origin().altitudeM()));
    return Point.of(terrain.riseEast(on.x(), on.y()), terrain.riseNorth(on.x(), on.y()), 0.0);
  }

  /** Nearest hit of ground or obstacles; empty if there is none within the range. */
  public Optional<Hit> cast(Ray ray, double rangeM) {
    ObstacleTree.Nearest nearest = nearest(ray, rangeM);
    return nearest.distanceM() <= rangeM
        ? Optional.of(
            new Hit(
                nearest.distanceM(),
                ray.at(nearest.distanceM()),
                Optional.ofNullable(nearest.object())))
        : Optional.empty();
  }

  /** Distance of {@link #cast} [m]; infinite if there is no hit within the range. */
  public double distanceM(Ray ray, double rangeM) {
    double nearest = nearest(ray, rangeM).distanceM();
    return nearest <= rangeM ? nearest : Double.POSITIVE_INFINITY;
  }

  private ObstacleTree.Nearest nearest(Ray ray, double rangeM) {
    ObstacleTree.Nearest none =
        new ObstacleTree.Nearest(Math.nextUp(rangeM), null); // includes hits exactly at the range
    ObstacleTree.Nearest hit = tree.isEmpty() ? none : tree.get().nearest(ray, none);
    if (!hasBed() && water.map(all -> all.depthM(ray.z()) >= 0.0).orElse(false)) {
      return hit; // in the water: a world without terrain has no bed
    }
    double ground = terrain.distanceM(ray, Math.min(rangeM, hit.distanceM()));
    return ground < hit.distanceM() ? new ObstacleTree.Nearest(ground, null) : hit;
  }

  /** Whether there is ground below the water: without a terrain of its own the world has no bed. */
  private boolean hasBed() {
    return terrain != Terrain.flat();
  }

  /**
   * Whether a hull touches the bed or shore at a corner or below its reference point.
   *
   * @param place position of the reference point: east, north, up [m]
   * @param headingRad heading, clockwise from north [rad]
   */
  public boolean isAground(Footprint hull, Point place, double headingRad) {
    return hasBed() && hull.at(place, headingRad).isBelow(terrain, place);
  }

  /**
   * Obstacles a vehicle touches, excluding the ground it stands on.
   *
   * @param place position of the vehicle's reference point: east, north, up [m]
   * @param headingRad heading, clockwise from north [rad]
   */
  public List<ObjectDescription> contacts(Footprint footprint, Point place, double headingRad) {
    List<ObjectDescription> found = new ArrayList<>();
    if (tree.isPresent() && tree.get().reaches(footprint.around(place))) {
      Prism prism = footprint.at(place, headingRad);
      tree.get().touched(prism, prism.bounds(), found::add);
    }
    return found;
  }
}
