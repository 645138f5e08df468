package org.u2sa.planning.seen;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.Inflation;
import org.u2sa.planning.search.WayBeyond;

/**
 * The World Modeler's newest objects and grid on one plane: static obstacles, traffic, and the cost
 * grid. Confined to the planner's thread.
 *
 * <p>The cost window stays in place until the vehicle comes near its edge, so that changes are
 * known per cell.
 */
public final class SeenWorld {
  /** The window moves when the vehicle is closer to its edge than this fraction of its span. */
  private static final double EDGE_SHARE = 0.2;

  private static final double SURE = 0.6; // minimum confidence of observed (not inferred) objects

  /**
   * Settings for reading the world.
   *
   * @param cellM edge of a cell [m]
   * @param spanM edge of the window [m]
   * @param inflation cost of proximity to obstacles
   * @param occupiedAbove probability above which a cell of the World Modeler's grid counts as
   *     occupied
   * @param corridorType objects of this type are areas to stay inside
   * @param ignoredTypes objects of these types are not obstacles
   * @param heightMarginM objects this far above or below may be passed over or under [m]; 0:
   *     heights do not matter
   * @param leaveM a vehicle inside the separation of traffic that stands may leave it: the traffic
   *     is then drawn only up to this distance from the vehicle [m]; 0: in full
   */
  public record Reading(
      double cellM,
      double spanM,
      Inflation inflation,
      double occupiedAbove,
      String corridorType,
      List<String> ignoredTypes,
      double heightMarginM,
      double leaveM) {}

  private final Supplier<Reading> reading;
  private final TrafficMemory memory = new TrafficMemory();
  private final WorldAge age = new WorldAge();
  private PlanningPlane plane;
  private ObjectList objects;
  private OccupancyGrid seenGrid;
  private List<PlanarShape> shapes = List.of();
  private List<PlanarShape> drawn = List.of(); // likewise, without separations the vehicle is in
  private List<PlanarShape> corridors = List.of();
  private List<Mover> movers = List.of();
  private List<PlanarShape> otherShapes = List.of(); // shapes at other heights
  private List<Mover> otherMovers = List.of(); // likewise
  private boolean bodyOnly;
  private boolean changed = true;
  private double lowDownM;
  private double highDownM;
  private CostGrid costs;
  private Reading costsRead;
  private GridLayer layer; // last drawn
  private CorridorLayer outside; // likewise
  private GroundLayer high; // likewise; null: no ground counts
  private FlightProfile profile; // null: no ground counts
  private DoubleBinaryOperator groundDownM;
  private FarGround farGround = new FarGround();
  private int revision;
  private boolean overlooks;
  private List<PlanarShape> guessed = List.of();

  public SeenWorld(Supplier<Reading> reading) {
    this.reading = reading;
  }

  /** Sets whether inferred objects are ignored. */
  public void overlook(boolean guesses) {
    changed |= guesses != overlooks;
    overlooks = guesses;
  }

  /** Sets the planner's virtual obstacles, until {@link #overlook} or the next call. */
  public void guess(List<PlanarShape> closed) {
    changed |= !closed.equals(guessed);
    guessed = List.copyOf(closed);
  }

  /**
   * Sets which ground counts as an obstacle: what is too high to fly over, until the next call.
   *
   * @param flown altitudes to be flown; empty: no ground counts
   * @param ground down coordinate of the ground on the plane, at north and east [m]; NaN if unknown
   */
  public void flyAbove(Optional<FlightProfile> flown, DoubleBinaryOperator ground) {
    changed |= !flown.equals(Optional.ofNullable(profile));
    profile = flown.orElse(null);
    groundDownM = ground;
  }

  /** Updates the objects, which have just arrived [µs]. */
  public void see(ObjectList list, long nowMicros) {
    objects = list;
    age.see(list, nowMicros);
    changed = true;
  }

  /** Updates the grid; parameters as above. */
  public void see(OccupancyGrid grid, long nowMicros) {
    seenGrid = grid;
    age.see(grid, nowMicros);
    changed = true;
  }

  /** Uses only objects in vehicle axes, because the vehicle's position is unknown. */
  public void onlyFromVehicle(boolean only) {
    changed |= only != bodyOnly;
    bodyOnly = only;
  }

  /** Centre of an object on the state's plane: north, east, down [m]. */
  public Point centre(ObjectDescription object, StateInformation state) {
    return new ObjectReader(plane(state), state).centre(object);
  }

  /** Outlines of all {@link #objects()} on the state's plane. */
  public List<PlanarShape> outlines(StateInformation state) {
    ObjectReader reader = new ObjectReader(plane(state), state);
    return objects().stream().map(reader::shape).collect(Collectors.toList());
  }

  /** Outline of an object or area on the state's plane. */
  public PlanarShape outline(ObjectDescription object, StateInformation state) {
    return new ObjectReader(plane(state), state).shape(object);
  }

  /** Newest objects; only those in vehicle axes while the vehicle's position is unknown. */
  public List<ObjectDescription> objects() {
    List<ObjectDescription> all = objects == null ? List.of() : objects.objects();
    return bodyOnly
        ? all.stream()
            .filter(object -> object.referenceFrame().isBody())
            .collect(Collectors.toList())
        : all;
  }

  private OccupancyGrid grid() {
    return bodyOnly && seenGrid != null && !seenGrid.referenceFrame().isBody() ? null : seenGrid;
  }

  public WorldAge age() {
    return age;
  }

  /** Plane; a new one by the state if the previous one does not fit. */
  public PlanningPlane plane(StateInformation state) {
    if (plane == null || plane.onEarth() == state.referenceFrame().isLocal()) {
      plane = PlanningPlane.at(state);
      guessed = List.of();
      profile = null;
      high = null;
      farGround = new FarGround();
      changed = true;
      costs = null;
    }
    return plane;
  }

  public List<PlanarShape> shapes() {
    return shapes;
  }

  /** Convex outlines of ground that is too high to fly over, as of the last update. */
  public List<PlanarShape> highGround() {
    return high == null || profile == null ? List.of() : high.shapes();
  }

  /** Whether ground is too high to fly over, in the window or between it and the goal. */
  public boolean hasHighGround() {
    return !highGround().isEmpty() || profile != null && costs != null && costs.leadsAround();
  }

  /** Areas, at least one of which must contain the vehicle. */
  public List<PlanarShape> corridors() {
    return corridors;
  }

  public List<Mover> movers() {
    return movers;
  }

  /** Static obstacles omitted because of their heights. */
  public List<PlanarShape> shapesElsewhere() {
    return otherShapes;
  }

  /** Traffic at all heights. */
  public List<Mover> allMovers() {
    List<Mover> all = new ArrayList<>(movers);
    all.addAll(otherMovers);
    return all;
  }

  /** Objects currently in motion, even before {@link #update}, except ignored types. */
  public List<Mover> traffic(StateInformation state) {
    List<Mover> moving = new ArrayList<>();
    ObjectReader reader = new ObjectReader(plane(state), state);
    long micros = objects == null ? 0L : objects.timestamp().orElse(0L);
    for (ObjectDescription object : objects()) {
      if (!reading.get().ignoredTypes().contains(object.objectType())) {
        reader.mover(object, micros).filter(mover -> !mover.stands()).ifPresent(moving::add);
      }
    }
    return moving;
  }

  /** Revision that grows when a cost changes or the window moves. */
  public int revision() {
    return revision;
  }

  /**
   * Called where the vehicle is.
   *
   * @param at position on the plane: north, east [m]
   */
  public void pass(BodyDiscs body, Point at, double headingRad) {
    if (costs != null) {
      costs.passed().add(body, at.x(), at.y(), headingRad);
    }
  }

  /** Cost window, as of the last {@link #update}. */
  public CostGrid costs() {
    return costs;
  }

  /** Nearest object of a type; empty if none is seen, or none is on the state's plane. */
  public Optional<SeenTarget> nearest(String type, StateInformation state) {
    if (objects == null) {
      return Optional.empty();
    }
    PlanningPlane here = plane(state);
    ObjectReader reader = new ObjectReader(here, state);
    Point at =
        here.ned(
            here.frame(),
            Point.of(
                state.in(here.frame()).x().orElseThrow(),
                state.in(here.frame()).y().orElseThrow(),
                state.in(here.frame()).z().orElse(0.0)));
    SeenTarget nearest = null;
    for (ObjectDescription object : objects()) {
      if (object.objectType().equals(type)) {
        PlanarShape shape = reader.shape(object);
        Point ned = reader.centre(object).minus(at);
        double away = shape.distanceM(at.x(), at.y());
        if (nearest == null || away < nearest.distanceM()) {
          double radius = Math.max(0.0, Math.hypot(ned.x(), ned.y()) - away);
          nearest =
              new SeenTarget(
                  ned,
                  ned.z() - 0.5 * shape.heightM(),
                  ned.z() + 0.5 * shape.heightM(),
                  away,
                  radius);
        }
      }
    }
    return Optional.ofNullable(nearest);
  }

  /** All objects of a type, whether or not they are obstacles. */
  public List<PlanarShape> of(String type, StateInformation state) {
    List<PlanarShape> found = new ArrayList<>();
    ObjectReader reader = new ObjectReader(plane(state), state);
    for (ObjectDescription object : objects()) {
      if (object.objectType().equals(type)) {
        found.add(reader.shape(object));
      }
    }
    return found;
  }

  /**
   * Updates everything.
   *
   * @param state newest state of the vehicle
   * @param northM north coordinate of the vehicle on the plane [m]
   * @param eastM east coordinate of the vehicle on the plane [m]
   * @param downM down coordinate of the vehicle [m]
   * @param goalDownM down coordinate of the goal [m]; obstacles at heights between both are
   *     relevant
   */
  public void update(
      StateInformation state, double northM, double eastM, double downM, double goalDownM) {
    Reading now = reading.get();
    boolean moved =
        costs == null || !now.equals(costsRead) || isNearEdge(costs.frame(), northM, eastM);
    boolean otherHeights =
        now.heightMarginM() > 0.0
            && (Math.abs(lowDownM - Math.max(downM, goalDownM)) > 0.2 * now.heightMarginM()
                || Math.abs(highDownM - Math.min(downM, goalDownM)) > 0.2 * now.heightMarginM());
    if (!moved && !changed && !otherHeights) {
      return;
    }
    lowDownM = Math.max(downM, goalDownM);
    highDownM = Math.min(downM, goalDownM);
    readObjects(state, now, northM, eastM);
    if (moved) {
      double half = 0.5 * now.spanM();
      double north = now.cellM() * Math.rint((northM - half) / now.cellM());
      double east = now.cellM() * Math.rint((eastM - half) / now.cellM());
      int cells = (int) Math.ceil(now.spanM() / now.cellM());
      CostGrid before = costs;
      costs = new CostGrid(new GridFrame(north, east, now.cellM(), cells, cells), now.inflation());
      if (before != null) {
        costs.passed().addAll(before.passed());
      }
      costsRead = now;
    }
    boolean different = costs.update(states(now)) != null;
    if (different || moved) {
      revision++;
    }
    changed = false;
  }

  /**
   * Sets the goal, after {@link #update}: if it is outside the window, routes lead to the edge from
   * which the way on leads around ground that is too high.
   */
  public void leadTo(double goalNorthM, double goalEastM) {
    boolean isBeyond = profile != null && !costs.frame().contains(goalNorthM, goalEastM);
    Optional<WayBeyond> way =
        isBeyond
            ? farGround.way(profile, groundDownM, costs.frame(), goalNorthM, goalEastM)
            : Optional.empty();
    if (costs.leadOn(way)) {
      revision++;
    }
  }

  /** Cell states of the window according to the World Modeler's grid and all objects. */
  private byte[] states(Reading now) {
    OccupancyGrid grid = grid();
    if (grid != null) {
      layer = GridLayer.of(grid, plane, costs.frame(), now.occupiedAbove(), layer);
    }
    List<PlanarShape> closed = overlooks ? List.of() : guessed;
    if (profile != null) {
      high = GroundLayer.of(profile, groundDownM, costs.frame(), high);
    }
    boolean isLow = highGround().isEmpty();
    if (grid != null && drawn.isEmpty() && closed.isEmpty() && corridors.isEmpty() && isLow) {
      return layer.states();
    }
    GridRaster raster =
        grid == null ? new GridRaster(costs.frame()) : new GridRaster(costs.frame(), layer);
    drawn.forEach(raster::draw);
    closed.forEach(raster::draw);
    if (!corridors.isEmpty()) {
      outside = CorridorLayer.of(corridors, costs.frame(), outside);
      raster.draw(outside);
    }
    if (!isLow) {
      raster.draw(high);
    }
    return raster.states();
  }

  private static boolean isNearEdge(GridFrame frame, double northM, double eastM) {
    double margin = EDGE_SHARE * frame.rows() * frame.cellM();
    return northM < frame.northM() + margin
        || eastM < frame.eastM() + margin
        || northM > frame.northM() + frame.rows() * frame.cellM() - margin
        || eastM > frame.eastM() + frame.columns() * frame.cellM() - margin;
  }

  /** Whether it is an obstacle; what climbs or descends in place is not, where heights matter. */
  private boolean stands(Mover mover) {
    return mover.stands() && !(reading.get().heightMarginM() > 0.0 && mover.climbs());
  }

  /**
   * Current and possible motions of traffic. Where heights matter, what has just stopped may also
   * stay: a vehicle above or below it would otherwise expect it to leave.
   */
  private List<Mover> motions(Mover mover) {
    if (stands(mover)) {
      List<Mover> possible = new ArrayList<>(memory.mightMove(mover));
      if (!possible.isEmpty() && reading.get().heightMarginM() > 0.0) {
        possible.add(mover);
      }
      return possible;
    }
    memory.moves(mover);
    boolean mayStay = reading.get().heightMarginM() > 0.0 && mover.mayStay();
    return mayStay ? List.of(mover, mover.moving(0.0, 0.0)) : List.of(mover);
  }

  private void readObjects(StateInformation state, Reading now, double northM, double eastM) {
    List<PlanarShape> standing = new ArrayList<>();
    List<PlanarShape> standingApart = new ArrayList<>();
    List<PlanarShape> stayInside = new ArrayList<>();
    List<Mover> moving = new ArrayList<>();
    List<PlanarShape> standingElsewhere = new ArrayList<>();
    List<Mover> movingElsewhere = new ArrayList<>();
    ObjectReader reader = new ObjectReader(plane, state);
    long micros = objects == null ? 0L : objects.timestamp().orElse(0L);
    for (ObjectDescription object : objects()) {
      boolean passable =
          now.ignoredTypes().contains(object.objectType())
              || object.level().filter(ObjectLevel.HINDRANCE::equals).isPresent()
              || overlooks && object.confidence().orElse(1.0) < SURE;
      if (passable) {
        continue;
      }
      PlanarShape shape = reader.shape(object);
      boolean isCorridor = object.objectType().equals(now.corridorType());
      if (now.heightMarginM() > 0.0 && !shape.reaches(lowDownM, highDownM, now.heightMarginM())) {
        Optional<Mover> mover = reader.mover(object, micros).filter(each -> !stands(each));
        mover.ifPresent(movingElsewhere::add);
        if (mover.isEmpty() && !isCorridor) {
          standingElsewhere.add(shape);
        }
        continue;
      }
      if (isCorridor) {
        stayInside.add(shape);
        continue;
      }
      Optional<Mover> mover = reader.mover(object, micros);
      List<Mover> motions = mover.map(this::motions).orElse(List.of());
      moving.addAll(motions);
      if (motions.isEmpty()) {
        standing.add(shape);
        boolean isSeparation = object instanceof MovingSphere && now.leaveM() > 0.0;
        (isSeparation ? shape.apartFrom(northM, eastM, now.leaveM()) : Optional.of(shape))
            .ifPresent(standingApart::add);
      }
    }
    shapes = List.copyOf(standing);
    drawn = List.copyOf(standingApart);
    corridors = List.copyOf(stayInside);
    movers = List.copyOf(moving);
    otherShapes = List.copyOf(standingElsewhere);
    otherMovers = List.copyOf(movingElsewhere);
  }
}
