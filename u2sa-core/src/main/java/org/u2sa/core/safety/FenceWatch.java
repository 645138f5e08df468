package org.u2sa.core.safety;

import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.motion.Drift;

/**
 * Checks that the vehicle can still stop or turn round inside the fence, if any. The floor applies
 * once the armed vehicle has been above it, so that it can take off. A fence with a floor or a
 * ceiling needs states with an altitude.
 */
final class FenceWatch implements Watch {
  private static final double ROUNDING_M = 1e-3;
  private static final String ABOVE_FLOOR = "above floor";
  private static final String ORDERED = "ordered fence";
  private static final String ORDERED_FILE = "ordered fence's file";
  private static final String NO_ALTITUDE = "no altitude";

  private final Configurator matrix;
  private final Supplier<SafetyVariables> settings;
  private final FenceFile file;
  private final PositionWatch states;
  private volatile GivenFence given; // null if none; written by the Safety Manager's thread
  private Fence fence; // its area less the margin
  private boolean isOrdered; // ordered by an operator, instead of the configured one
  private int changes; // number of changes of the fence in force
  private boolean aboveFloor;
  private Point clear =
      Point.of(0.0, 0.0, 0.0); // position at which the distance to the fence was last computed
  private double clearM; // free radius around it; 0 if unknown

  /** Loads the configured fence; throws if its file is invalid. */
  FenceWatch(
      Configurator matrix,
      Supplier<SafetyVariables> settings,
      FenceFile file,
      PositionWatch states) {
    this.matrix = matrix;
    this.settings = settings;
    this.file = file;
    this.states = states;
    load();
  }

  /** Checks states against a different fence, starting from another watch's state. */
  private FenceWatch(FenceWatch other, Fence fence) {
    matrix = other.matrix;
    settings = other.settings;
    file = other.file;
    states = other.states;
    aboveFloor = other.aboveFloor;
    this.fence = fence;
  }

  /** Reloads the configured fence; if its file is invalid, throws and keeps the current one. */
  void load() {
    use(file.load(settings.get()).orElse(null), false);
  }

  /** Applies an ordered fence instead of the configured one; empty: no fence. */
  void order(Optional<GivenFence> ordered) {
    use(ordered.orElse(null), true);
    file.forget();
  }

  /**
   * Continues with the fence that a predecessor without a saved state published, unless it is the
   * configured one or another has been ordered since. Throws if it is invalid or incomplete.
   *
   * @return whether the fence has changed
   */
  boolean resume(FenceState published) {
    if (isOrdered || published.file().isEmpty()) {
      return false;
    }
    String source = published.file().get();
    String xml =
        published
            .fence()
            .orElseThrow(() -> new BadInputException(source + ": too long to be published"));
    if (given != null && given.xml().equals(xml)) {
      return false;
    }
    order(Optional.of(given(source, xml)));
    return true;
  }

  /** Applies FENCE MARGIN to the fence in force; throws if no area remains. */
  void drawIn() {
    if (!isOrdered) {
      load();
    } else if (given != null) {
      use(given.drawnInBy(settings.get().fenceMargin()), true);
    }
  }

  private void use(GivenFence next, boolean ordered) {
    given = next;
    fence = next == null ? null : next.fence();
    isOrdered = ordered;
    clearM = 0.0;
    changes++;
  }

  /** Reads an ordered fence; throws, naming what is wrong, if it is invalid. */
  GivenFence given(String source, String xml) {
    return GivenFence.of(source, xml, settings.get().fenceMargin());
  }

  /** The configured fence, read again; throws if its file is invalid. */
  Optional<GivenFence> configured() {
    return file.read(settings.get());
  }

  /** Fault of the vehicle if another fence were in force; empty if none. */
  Optional<String> refusal(GivenFence other, long nowMicros) {
    return states.fresh(nowMicros).isEmpty()
        ? Optional.of("without a position to compare")
        : new FenceWatch(this, other.fence()).trouble(nowMicros);
  }

  /** Reason why the configuration with these values has an invalid fence; empty if none. */
  Optional<String> configurationRefusal(Map<String, Object> values) {
    boolean sameFile = settings.get().fence().equals(values.get(SafetyVariables.FENCE));
    if (!isOrdered || !sameFile || given == null) {
      return file.refusal(values, settings.get());
    }
    try {
      given.drawnInBy((Double) values.get(SafetyVariables.FENCE_MARGIN));
      return Optional.empty();
    } catch (BadInputException e) {
      return Optional.of(e.getMessage());
    }
  }

  /** The fence in force, for publication. */
  FenceState state() {
    double marginM = settings.get().fenceMargin();
    return given == null ? new FenceState().margin(marginM) : given.state(marginM);
  }

  /** Number of changes of the fence in force; a new value means that it must be published again. */
  int changes() {
    return changes;
  }

  /** Fence in force, shrunk by its margin; empty if none. */
  Optional<Fence> fence() {
    return Optional.ofNullable(fence);
  }

  /** Fence in force, without its margin; empty if none. Thread-safe. */
  Optional<Fence> whole() {
    GivenFence now = given;
    return Optional.ofNullable(now).map(GivenFence::whole);
  }

  @Override
  public Hazard hazard() {
    return Hazard.FENCE;
  }

  @Override
  public void see(U2SAData message, long nowMicros) {
    aboveFloor &= !(message instanceof ArmingState state) || state.armed();
  }

  @Override
  public void handOver(HandOver state, long nowMicros) {
    state.flag(ABOVE_FLOOR, aboveFloor);
    if (isOrdered) {
      state.text(ORDERED, given == null ? "" : given.xml());
      state.text(ORDERED_FILE, given == null ? "" : given.file());
    }
  }

  @Override
  public void takeOver(HandOver state, long nowMicros, boolean upToDate) {
    aboveFloor = state.flag(ABOVE_FLOOR);
    state
        .text(ORDERED)
        .ifPresent(
            xml ->
                order(
                    xml.isEmpty()
                        ? Optional.empty()
                        : Optional.of(given(state.text(ORDERED_FILE).orElse(""), xml))));
  }

  @Override
  public String saved() {
    return isOrdered ? aboveFloor + " " + changes : String.valueOf(aboveFloor);
  }

  @Override
  public Optional<String> trouble(long nowMicros) {
    return judged(nowMicros, this::trouble);
  }

  /** Trouble with the newest state: a violation, or a frame that does not fit the fence. */
  private Optional<String> judged(
      long nowMicros, Function<StateInformation, Optional<String>> judgement) {
    try {
      return states
          .fresh(nowMicros)
          .filter(state -> fence != null && state.x().isPresent() && state.y().isPresent())
          .flatMap(judgement);
    } catch (IllegalArgumentException e) {
      return Optional.of(e.getMessage());
    }
  }

  private Optional<String> trouble(StateInformation state) {
    double driftMps = Drift.measured(state).map(Drift::speedMps).orElse(0.0);
    Manoeuvre manoeuvre =
        Manoeuvre.of(settings.get(), Hazard.FENCE.action(matrix)).driftingAt(driftMps);
    Point place = fence.place(state);
    Point velocity = fence.velocity(state);
    if (!allows(manoeuvre, place, velocity)) {
      return Optional.of(ahead(manoeuvre, place, velocity));
    }
    if (lacksAltitude(state)) {
      return Optional.of("cannot be watched: " + NO_ALTITUDE);
    }
    return vertical(place.z(), manoeuvre.overshootM(velocity.z()));
  }

  /** Whether the fence limits an altitude that the state does not have. */
  private boolean lacksAltitude(StateInformation state) {
    return state.z().isEmpty() && (fence.floorM.isPresent() || fence.ceilingM.isPresent());
  }

  /** Runs the full check only if the fence may be within reach. */
  private boolean allows(Manoeuvre manoeuvre, Point place, Point velocity) {
    double reachM = manoeuvre.reachM(Math.hypot(velocity.x(), velocity.y()));
    if (Math.hypot(place.x() - clear.x(), place.y() - clear.y()) + reachM < clearM) {
      return true;
    }
    boolean allowed =
        settings.get().fenceManoeuvre().equals(Manoeuvre.TURN_TO_ONE_SIDE)
            ? fence.allows(manoeuvre.regionToOneSide(place, velocity, 1.0))
                || fence.allows(manoeuvre.regionToOneSide(place, velocity, -1.0))
            : fence.allows(manoeuvre.region(place, velocity));
    clear = place;
    clearM = allowed ? fence.clearanceM(place) - ROUNDING_M : 0.0;
    return allowed;
  }

  private String ahead(Manoeuvre manoeuvre, Point place, Point velocity) {
    if (!fence.allows(place)) {
      return "outside";
    }
    double speed = Math.hypot(velocity.x(), velocity.y());
    return manoeuvre.turns()
        ? "too near to turn with a radius of " + CauseText.metres(manoeuvre.turnRadiusM(speed))
        : "too near to stop within " + CauseText.metres(manoeuvre.wayToStopM(speed));
  }

  private Optional<String> vertical(double altitudeM, double overshootM) {
    double expectedM = altitudeM + overshootM;
    if (fence.ceilingM.isPresent()
        && Math.max(altitudeM, expectedM) > fence.ceilingM.getAsDouble()) {
      return Optional.of(
          "ceiling "
              + CauseText.metres(fence.ceilingM.getAsDouble())
              + " at "
              + CauseText.metres(altitudeM));
    }
    if (fence.floorM.isEmpty()) {
      return Optional.empty();
    }
    double floorM = fence.floorM.getAsDouble();
    boolean clear = Math.min(altitudeM, expectedM) >= floorM;
    aboveFloor |= clear;
    return aboveFloor && !clear
        ? Optional.of("floor " + CauseText.metres(floorM) + " at " + CauseText.metres(altitudeM))
        : Optional.empty();
  }

  /** A stationary vehicle must be inside, but may be too near to turn, e.g. on a runway. */
  @Override
  public Optional<String> objection(long nowMicros) {
    Optional<String> fault = file.fault();
    return fault.isPresent() ? fault : judged(nowMicros, this::objection);
  }

  private Optional<String> objection(StateInformation state) {
    if (!fence.allows(fence.place(state))) {
      return Optional.of("outside the keep-in area, or inside a keep-out one");
    }
    return lacksAltitude(state) ? Optional.of(NO_ALTITUDE) : Optional.empty();
  }
}
