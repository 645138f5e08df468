package org.u2sa.planning.avoidance;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.planning.avoidance.Avoidance.Wanted;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.AllowedAreas;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.HoverMotions;
import org.u2sa.planning.local.HoverMotions.Choice;
import org.u2sa.planning.local.VerticalRoom;
import org.u2sa.planning.seen.Mover;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Keeps an aircraft that hovers, or flies straight to where it will hover, away from traffic: to
 * the side inside the fence, up or down. Confined to the planner's thread.
 */
final class HoverEvasion {
  private static final long LASTS_MICROS = 10 * Clock.MICROS_PER_SECOND;
  private static final long GOES_ON_MICROS = 2 * Clock.MICROS_PER_SECOND;
  private static final long NEVER = Long.MIN_VALUE / 2;
  private static final long DECIDES_EVERY_MICROS = Clock.MICROS_PER_SECOND / 5;
  private static final double IMMINENT = 0.5; // distance in radii of the clearance

  private final SeenWorld world;
  private final VerticalEvasion climbing;
  private final AllowedAreas fence;
  private final Supplier<AvoidanceVariables> settings;
  private final Supplier<LineSettings> lines;
  private final BiConsumer<String, Boolean> say;
  private Choice last; // null: it has not evaded yet
  private long decidedMicros = NEVER; // when it was chosen, unless the way was free since
  private long lastMicros = NEVER; // of the last evasion
  private boolean isBraking;

  HoverEvasion(
      SeenWorld world,
      VerticalEvasion climbing,
      Supplier<AvoidanceVariables> settings,
      Supplier<LineSettings> lines,
      BiConsumer<String, Boolean> say) {
    this.world = world;
    this.climbing = climbing;
    this.settings = settings;
    this.lines = lines;
    this.say = say;
    fence = new AllowedAreas(world);
  }

  /** Receives the fence in force. */
  void see(FenceState inForce) {
    fence.see(inForce);
  }

  /**
   * Evasive motion, as of the last update of the world; empty if the way is free of traffic.
   *
   * @param way to where it will hover: north, east, down [m]
   */
  Optional<ArcChoice> choose(Vehicle vehicle, StateInformation state, Point way) {
    AvoidanceVariables now = settings.get();
    Point at = vehicle.on(world.plane(state));
    Place to = vehicle.place().at(vehicle.place().upM().orElseThrow() - way.z());
    Optional<VerticalRoom> room =
        climbing.room(state, at, way, to, now, world, world.plane(state), Optional.empty());
    List<Mover> traffic = room.isPresent() ? world.allMovers() : world.movers();
    long micros = vehicle.timestampMicros();
    boolean goesOn = isUnderWay(micros);
    if (traffic.isEmpty() && !goesOn) {
      return Optional.empty();
    }
    Wanted wanted = new Wanted("", to, 0.0, OptionalDouble.empty(), OptionalDouble.empty());
    Pose pose = new Pose(at.x(), at.y(), vehicle.headingRad());
    double cellM = world.costs().frame().cellM();
    Situation situation = Situation.of(pose, way, wanted, vehicle, cellM, now, lines.get());
    HoverMotions motions =
        new HoverMotions(
            world.costs(),
            situation.body().circleM(),
            now.clearance(),
            traffic,
            situation.limits(),
            room,
            fence.area(at, state),
            micros);
    boolean isFresh = goesOn && micros - decidedMicros < DECIDES_EVERY_MICROS;
    Optional<Choice> chosen =
        isFresh
            ? Optional.of(motions.again(last, at))
            : motions.choose(
                at,
                Point.of(vehicle.northMps(), vehicle.eastMps(), 0.0),
                at.plus(way),
                goesOn ? Optional.of(last.spot()) : Optional.<Point>empty());
    if (!isFresh) {
      decidedMicros = chosen.isPresent() ? micros : NEVER;
    }
    last = chosen.orElse(last);
    Optional<ArcChoice> choice = chosen.map(HoverEvasion::motion);
    choice.ifPresent(evasion -> tell(evasion, at, micros));
    return choice;
  }

  /** Whether it evaded until a moment ago. */
  boolean isUnderWay(long micros) {
    return last != null && micros - lastMicros <= GOES_ON_MICROS;
  }

  private static ArcChoice motion(Choice chosen) {
    return new ArcChoice(
        chosen.spot().x(),
        chosen.spot().y(),
        chosen.speedMps(),
        false,
        chosen.distance() < IMMINENT ? ArcChoice.Kind.BRAKE : ArcChoice.Kind.EVADE,
        chosen.spot().z());
  }

  private void tell(ArcChoice evasion, Point at, long micros) {
    boolean isNew = micros - lastMicros > LASTS_MICROS;
    boolean brakes = evasion.kind() == ArcChoice.Kind.BRAKE;
    if (isNew) {
      say.accept("traffic comes to where it hovers: evading until it has passed", false);
    }
    if (brakes && (isNew || !isBraking)) {
      say.accept("traffic comes close: evading as far as possible", true);
    }
    isBraking = brakes;
    lastMicros = micros;
    climbing.chosen(evasion, at, micros);
  }
}
