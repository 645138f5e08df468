package org.u2sa.sim.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.atmosphere.WindField;

/**
 * Everything around the vehicles of a run: ground, obstacles, wind and water. Places are east,
 * north, up [m] on a plane that touches the earth at the origin. Immutable, so that every thread
 * may look at it; what changes is a new world with the same rest.
 */
public final class World {
  private final LocalPlane plane;
  private final Terrain terrain;
  private final Surface surface;
  private final Wind wind;
  private final Optional<Water> water;
  private final List<ObjectDescription> obstacles;
  private final Optional<ObstacleTree> tree;

  /**
   * The nearest thing on a ray.
   *
   * @param distanceM from the start of the ray [m]
   * @param at where, east, north, up [m]
   * @param object what; empty: the ground
   */
  public record Hit(double distanceM, Point at, Optional<ObjectDescription> object) {}

  private World(
      LocalPlane plane,
      Terrain terrain,
      Surface surface,
      Wind wind,
      Optional<Water> water,
      List<ObjectDescription> obstacles,
      Optional<ObstacleTree> tree) {
    this.plane = plane;
    this.terrain = Objects.requireNonNull(terrain, "terrain");
    this.surface = Objects.requireNonNull(surface, "surface");
    this.wind = Objects.requireNonNull(wind, "wind");
    this.water = water;
    this.obstacles = obstacles;
    this.tree = tree;
  }

  /** A level lawn without obstacles or wind, as high everywhere as its origin. */
  public static World at(Geodetic origin) {
    return new World(
        new LocalPlane(origin),
        Terrain.flat(),
        Surface.lawn(),
        Wind.calm(),
        Optional.empty(),
        List.of(),
        Optional.empty());
  }

  /** The same with other ground under it. */
  public World with(Terrain newTerrain) {
    return new World(plane, newTerrain, surface, wind, water, obstacles, tree);
  }

  /** The same on another surface. */
  public World with(Surface newSurface) {
    return new World(plane, terrain, newSurface, wind, water, obstacles, tree);
  }

  /** The same in another wind. */
  public World with(Wind newWind) {
    return new World(plane, terrain, surface, newWind, water, obstacles, tree);
  }

  /** The same with water in it. */
  public World with(Water newWater) {
    return new World(plane, terrain, surface, wind, Optional.of(newWater), obstacles, tree);
  }

  /**
   * The same with these obstacles instead. Their frame is LOCAL_ENU or LOCAL_NED about the world's
   * origin, or GLOBAL or UTM, where z is the altitude. Flat shapes, lines and points lie where they
   * are: rays from above meet a disc or a rectangle, no ray meets a line or a point.
   *
   * @throws IllegalArgumentException if one is in a vehicle's frame or of an unknown shape
   */
  public World with(List<? extends ObjectDescription> newObstacles) {
    List<ObstacleTree.Leaf> leaves = new ArrayList<>();
    for (ObjectDescription object : newObstacles) {
      Obstacle shape = Obstacle.of(object, plane);
      leaves.add(new ObstacleTree.Leaf(object, shape, shape.bounds()));
    }
    return new World(
        plane,
        terrain,
        surface,
        wind,
        water,
        List.copyOf(newObstacles),
        leaves.isEmpty() ? Optional.empty() : Optional.of(ObstacleTree.of(leaves)));
  }

  /** Where on earth it is. */
  public LocalPlane plane() {
    return plane;
  }

  /** Height and slope of the ground. */
  public Terrain terrain() {
    return terrain;
  }

  /** How slippery and soft the ground is. */
  public Surface surface() {
    return surface;
  }

  /** The wind. */
  public Wind wind() {
    return wind;
  }

  /** The wind along the way of one vehicle of that span [m]. */
  public WindField windAround(double spanM) {
    return new WindField(wind, spanM);
  }

  /** The water, if there is any. */
  public Optional<Water> water() {
    return water;
  }

  /** All obstacles, as they were given. */
  public List<ObjectDescription> obstacles() {
    return obstacles;
  }

  /**
   * Elevation of the ground above mean sea level [m] at a WGS-84 position [°].
   *
   * @throws IllegalStateException if the terrain gives no number there
   */
  public double elevationM(double longitudeDeg, double latitudeDeg) {
    double origin = plane.origin().altitudeM();
    if (terrain == Terrain.flat()) {
      return origin; // as far as anything flies
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

  /** The nearest of ground and obstacles on a ray; empty if there is nothing within the range. */
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

  /** The distance of {@link #cast} alone [m]; infinite if there is nothing within the range. */
  public double distanceM(Ray ray, double rangeM) {
    double nearest = nearest(ray, rangeM).distanceM();
    return nearest <= rangeM ? nearest : Double.POSITIVE_INFINITY;
  }

  private ObstacleTree.Nearest nearest(Ray ray, double rangeM) {
    ObstacleTree.Nearest none =
        new ObstacleTree.Nearest(Math.nextUp(rangeM), null); // what is at the range is seen
    ObstacleTree.Nearest hit = tree.isEmpty() ? none : tree.get().nearest(ray, none);
    double ground = terrain.distanceM(ray, Math.min(rangeM, hit.distanceM()));
    return ground < hit.distanceM() ? new ObstacleTree.Nearest(ground, null) : hit;
  }

  /**
   * The obstacles that a vehicle touches. The ground is none of them: it stands on that.
   *
   * @param place of the vehicle's reference point, east, north, up [m]
   * @param headingRad clockwise from north [rad]
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
