package org.u2sa.planning.avoidance;

import java.util.Optional;
import java.util.function.BiConsumer;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.RouteTrack;

/**
 * The attempt to reach one goal, a state machine:
 *
 * <pre>
 * {@link Searching} ── route found ──▶ {@link Following} ── no progress ──▶ {@link BackingOut}
 *        ◀── route blocked, none left ──           │                             │
 *        ◀──────── {@link BackingOut} ahead ◀── leads back over unseen ground    │
 *        ◀───────────────────────── backed out ─────────────────────────────────┘
 * </pre>
 *
 * <p>It ends with a reason for giving up, or when the goal is reached. Confined to the planner's
 * thread.
 */
final class GoalAttempt {
  private static final int BACKING_SHARE = 3; // divisor of STUCK AFTER: duration of backing out

  /** Duration of the search for a way ahead: one noisy scan may close a narrow passage. */
  private static final long AHEAD_MICROS = 4 * Clock.MICROS_PER_SECOND;

  private final RouteKeeper routes;
  private final Passages passages;
  private final BiConsumer<String, Boolean> say;
  private final ProgressWatch watch;
  private final TrafficHold hold;
  private Behaviour behaviour;
  private int recoveries;
  private boolean triedAhead; // and found no route other than over unseen ground behind
  private long overlooksUntil = Long.MIN_VALUE;

  /**
   * @param say reports a message to the operator; true for a warning
   * @param micros time of the first step [µs]
   * @param pursued {@link org.u2sa.planning.goals.PursuitTime} of the first step [µs]
   */
  GoalAttempt(
      RouteKeeper routes,
      Passages passages,
      BiConsumer<String, Boolean> say,
      long micros,
      long pursued) {
    this.routes = routes;
    this.passages = passages;
    this.say = say;
    watch = new ProgressWatch(micros);
    hold = new TrafficHold(micros, pursued);
    behaviour = new Searching(routes, micros);
  }

  boolean hasRecovered() {
    return recoveries > 0;
  }

  /**
   * Whether to ignore obstacles that are inferred rather than observed. Done for a while after some
   * time without a free route: a gap may have been closed in error.
   */
  boolean overlooks(AvoidanceVariables settings, long micros) {
    if (at(micros) instanceof Searching search && search.doubtsObstacles(settings, micros)) {
      if (micros >= overlooksUntil) {
        say.accept("no route: passing through doubtful obstacles", false);
        routes.tryAgain();
      }
      overlooksUntil = micros + settings.overlookMicros();
    }
    return micros < overlooksUntil;
  }

  /** Chooses the motion of this step, after {@link RouteKeeper#update}. */
  ArcChoice choose(ArcChooser arcs, Situation now) {
    behaviour = next(at(now.micros()), now.micros());
    ArcChoice choice = behaviour.choose(arcs, now);
    return behaviour instanceof Following && backsUnseen(choice) ? ahead(arcs, now) : choice;
  }

  private boolean backsUnseen(ArcChoice choice) {
    return !triedAhead
        && choice.kind() == ArcChoice.Kind.MAKE_ROOM
        && choice.backwards()
        && routes.endsUnseen(choice);
  }

  /** Looks for a route ahead before backing where nothing was seen. */
  private ArcChoice ahead(ArcChooser arcs, Situation now) {
    triedAhead = true;
    long until = now.micros() + AHEAD_MICROS;
    behaviour = new BackingOut(until, new Searching(routes, now.micros()), true);
    routes.tryAhead(now, until);
    return behaviour.choose(arcs, now);
  }

  private Behaviour at(long micros) {
    return behaviour instanceof BackingOut backing ? backing.at(micros) : behaviour;
  }

  private Behaviour next(Behaviour current, long micros) {
    boolean goesAhead = current instanceof BackingOut out && out.isAhead();
    if (current instanceof BackingOut && !goesAhead) {
      return current;
    }
    Optional<RouteTrack> track = routes.track();
    if (track.isEmpty()) {
      return current instanceof Searching || goesAhead ? current : new Searching(routes, micros);
    }
    triedAhead &= !goesAhead;
    return current instanceof Following following && following.isAlong(track.get())
        ? current
        : new Following(track.get(), watch);
  }

  /**
   * Evaluates the progress, and frees the vehicle if it is stuck.
   *
   * @param choice motion of this step
   * @param trafficNear whether traffic can reach the vehicle soon
   * @param pursued {@link org.u2sa.planning.goals.PursuitTime} [µs]
   * @return reason for giving up, or empty
   */
  Optional<String> judge(ArcChoice choice, boolean trafficNear, Situation now, long pursued) {
    leaveOut(hold.pass(choice.kind(), trafficNear, now.micros(), pursued));
    Optional<String> reason = behaviour.givesUp(now);
    if (reason.isPresent() || !behaviour.isStuck(now)) {
      return reason;
    }
    if (recoveries >= now.settings().recoveries()) {
      return Optional.of(
          choice.kind() == ArcChoice.Kind.WAIT
              ? "traffic or obstacles leave no room to move"
              : "stuck after " + recoveries + " attempts to free itself");
    }
    backOut(now);
    return Optional.empty();
  }

  /** Excludes time in which the vehicle could not come nearer [µs]. */
  void leaveOut(long micros) {
    behaviour.leaveOut(micros);
    watch.leaveOut(micros);
  }

  private void backOut(Situation now) {
    recoveries++;
    passages.widen();
    say.accept(
        "stuck: freeing itself, attempt " + recoveries + " of " + now.settings().recoveries(),
        false);
    long until = now.micros() + now.settings().stuckMicros() / BACKING_SHARE;
    behaviour = new BackingOut(until, new Searching(routes, now.micros()), false);
    routes.dropUntil(until - now.settings().replanMicros()); // replan then
  }
}
