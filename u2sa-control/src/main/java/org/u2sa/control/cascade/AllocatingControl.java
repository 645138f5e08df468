package org.u2sa.control.cascade;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.control.ControlSystem;
import org.u2sa.control.Transfer;
import org.u2sa.control.allocation.ActuatorRoster;
import org.u2sa.control.allocation.Allocator;
import org.u2sa.control.allocation.Authority;
import org.u2sa.control.allocation.DegreeOfFreedom;
import org.u2sa.control.allocation.Effector;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ForceCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;

/**
 * Controls any vehicle using the effects its actuators announce (thesis 3.2.3.5: "discover which
 * actuators exist, … and how those actuators influence the state"). In: navigation, state,
 * actuators, health, arming-state, manual-state. Out: actuation of every actuator that announced a
 * numeric effect.
 *
 * <p>Position → velocity → force and angle → rate → moment, by cascaded PIDs ({@link Cascade}), and
 * weighted allocation ({@link Allocator}). A multirotor moves sideways by leaning (LEANS). When an
 * actuator appears, disappears or weakens, the next state is allocated accordingly, and health
 * reports the remaining authority. Without fresh navigation the vehicle stops and keeps its
 * heading. Without any state it approaches the point using motion estimated from sightings of the
 * point ({@link SeenMotion}) or measured by the vehicle's sensors ({@link SensedMotion}), and
 * releases the actuators when no point arrives (thesis 4.3.2).
 */
public final class AllocatingControl extends ControlSystem {
  /** Unit of actuator commands. */
  private enum CommandKind {
    PERCENT,
    FORCE
  }

  private record Choices(
      @Variable(ifAbsentText = "")
          @Description(
              "Names of the actuators to use, separated by commas; empty: all that are announced.")
          String actuators,
      @Variable(ifAbsentText = "")
          @Description(
              "Essential axes, separated by spaces: without them the actuators stay neutral. SURGE, SWAY, HEAVE, ROLL, PITCH, YAW.")
          String essential,
      @Variable(ifAbsentText = "")
          @Description(
              "Relative costs of actuators, as \"NAME 4, OTHER NAME 2\"; others cost 1. Costlier actuators are used less.")
          String costs,
      @Variable(ifAbsentText = "PERCENT")
          @Description(
              "FORCE commands actuators that accept forces in newtons, others in percent; PERCENT commands all in percent.")
          CommandKind commands,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether failed or weak actuators are detected from the vehicle's motion and excluded or derated; requires accurate masses.")
          boolean watchesResponse,
      @Variable(unit = "s", min = 1, max = 3600, ifAbsent = 60)
          @Description("Time after which a failed or weak actuator is tried again.")
          double retryTime,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether motion comes from an IMU and a velocity log on sensed-state while there are no states. Once both have reported, the actuators are neutral while either is silent.")
          boolean sensesMotion) {
    Choices {
      axes(essential);
      Costs.parse(costs);
    }

    boolean use(String actuatorName) {
      return actuators.trim().isEmpty()
          || Arrays.asList(actuators.trim().split("\\s*,\\s*")).contains(actuatorName);
    }

    static Set<DegreeOfFreedom> axes(String text) {
      Set<DegreeOfFreedom> axes = EnumSet.noneOf(DegreeOfFreedom.class);
      for (String word : text.trim().isEmpty() ? new String[0] : text.trim().split("[\\s,]+")) {
        try {
          axes.add(DegreeOfFreedom.valueOf(word));
        } catch (IllegalArgumentException e) {
          throw new IllegalArgumentException(
              "ESSENTIAL: \"" + word + "\" is none of SURGE, SWAY, HEAVE, ROLL, PITCH, YAW", e);
        }
      }
      return axes;
    }
  }

  private static final Set<DegreeOfFreedom> HORIZONTAL =
      EnumSet.of(DegreeOfFreedom.SURGE, DegreeOfFreedom.SWAY, DegreeOfFreedom.YAW);
  private static final long WAIT_MICROS = Clock.MICROS_PER_SECOND;
  private static final long NOT_YET = Long.MIN_VALUE;
  private static final double UNKNOWN_SHARE = 0.75; // fraction of the maximum speed, 1 sigma

  private final Settings<Choices> choices = settings(Choices.class);
  private final CascadeVariables tuning = new CascadeVariables(this);
  private final ActuatorRoster roster = new ActuatorRoster();
  private final Cascade cascade = new Cascade(tuning);
  private final SeenMotion seen = new SeenMotion();
  private final SensedMotion sensed = new SensedMotion();
  private final ResponseWatch response = new ResponseWatch();
  private final WeakActuators weak = new WeakActuators();
  private final double[] masses = new double[DegreeOfFreedom.COUNT];
  private final AxisTuner tuner = new AxisTuner(settings(AxisTuner.Order.class));
  private Allocator allocator = new Allocator(tuning.weights());
  private Authority sound = Authority.NONE;
  private Authority left = Authority.NONE;
  private boolean lacksEssentials; // an essential axis is lost
  private boolean isSurgeLost; // not driven without moving or turning otherwise
  private boolean isAdrift; // neither drives nor turns without doing both
  private long revision = -1;
  private String said = "";
  private final PilotWatch pilot = new PilotWatch(clock());
  private final StatePace pace = new StatePace();
  private boolean armed = true; // without an arming service, actuators obey
  private boolean waits = true; // until an arming service reports, or none has for WAIT_MICROS
  private boolean stood = cascade.stands(); // on the ground, in the last step
  private long firstMicros = NOT_YET; // of the first state
  private boolean isArmedBySomebody; // required for tuning
  private boolean isBlind;
  private boolean wentBySight; // in the previous step
  private boolean isMeasured; // has been controlled by IMU and velocity log
  private boolean coasts; // its horizontal velocity is unknown
  private boolean wasUnderWay; // was to move at the previous step
  private boolean takesOver;
  private double fluidMps; // speed of the newest state through air or water
  private OptionalDouble headingBefore = OptionalDouble.empty();

  public AllocatingControl(ServiceContext context) {
    super(context, "Control");
    subscribe(Channels.ACTUATORS, this::see);
    subscribe(Channels.HEALTH, roster::see);
    subscribe(Channels.ARMING_STATE, this::heed);
    subscribe(Channels.MANUAL_STATE, pilot::see);
    if (choices.get().sensesMotion()) {
      subscribe(Channels.SENSED_STATE, measured -> sensed.sensed(measured, clock().micros()));
    }
  }

  private void see(ActuatorAnnouncement announced) {
    if (choices.get().use(announced.actuatorName())) {
      roster.see(announced, clock().micros());
    }
  }

  private void heed(ArmingState state) {
    armed = state.armed();
    isArmedBySomebody = armed;
    waits = false;
  }

  @Override
  protected void configurationChanged(Set<String> variableNames) {
    cascade.retune();
    roster.keep(choices.get()::use);
    allocator = new Allocator(tuning.weights());
    revision = -1;
  }

  @Override
  protected void control(StateInformation state, Optional<NavigationPoint> point) {
    lookAtActuators();
    Optional<BodyMotion> motion = motion(state, point);
    if (motion.isEmpty() != isBlind) {
      isBlind = motion.isEmpty();
      if (isBlind) {
        trouble(
            isMeasured && isStateless()
                ? "no IMU, velocity log or navigation point: actuators are neutral"
                : tuning.leans()
                    ? "the state lacks roll, pitch, heading or velocity: actuators are neutral"
                    : "the state lacks heading or velocity: actuators are neutral");
      } else {
        log("heading and velocity are known again");
      }
    }
    boolean isReady = armed && !roster.isWithheld() && !(tuning.leans() && waits());
    if (isBlind || !isReady || lacksEssentials) {
      if (isReady) {
        cascade.rest();
      } else {
        cascade.stand();
        rememberWhetherItStands();
      }
      tuner.abort();
      response.restart();
      neutral().forEach(this::command);
      return;
    }
    if (pilot.flies()) {
      cascade.rest(); // else its integrals would rule when the pilot gives back
      tuner.abort();
      response.restart();
    }
    if (tuning.leans()) {
      lookAtPace(state);
    }
    fluidMps = motion.get().speedThroughFluidMps(state);
    drive(motion.get(), target(state, point));
  }

  private void lookAtPace(StateInformation state) {
    long now = clock().micros();
    double ageS = Clock.seconds(now - state.timestamp().orElse(now));
    Optional<String> words = pace.step(tuning, stepS(), ageS);
    words.ifPresent(late -> remark("pace", late));
    words.filter(late -> !late.isEmpty()).ifPresent(this::trouble);
  }

  private void rememberWhetherItStands() {
    if (cascade.stands() != stood) {
      stood = !stood;
      remember();
    }
  }

  /**
   * Whether a Safety Manager may still say that the vehicle is not armed: it must not lift off
   * until then.
   */
  private boolean waits() {
    if (firstMicros == NOT_YET) {
      firstMicros = clock().micros();
    }
    waits &= clock().micros() - firstMicros < WAIT_MICROS;
    return waits;
  }

  @Override
  protected boolean obeysWithoutState() {
    return !tuning.leans(); // leaning requires the attitude
  }

  private Optional<BodyMotion> motion(StateInformation state, Optional<NavigationPoint> point) {
    coasts = !isStateless() && isVelocityUnknown(state);
    if (isStateless() != wentBySight) {
      wentBySight = isStateless();
      cascade.rest(); // its state was estimated from other axes
      seen.rest();
    }
    Optional<BodyMotion> measured = sensed.now(clock().micros());
    cascade.goBySight(isStateless(), measured.isPresent());
    isMeasured |= measured.isPresent();
    if (isStateless() && isMeasured && measured.isEmpty()) {
      return Optional.empty(); // lost: sightings are propagated by the same sensors
    }
    if (isStateless()) {
      Point acceleration =
          Point.of(
              cascade.attained(DegreeOfFreedom.SURGE),
              cascade.attained(DegreeOfFreedom.SWAY),
              cascade.attained(DegreeOfFreedom.HEAVE));
      double turning = cascade.attained(DegreeOfFreedom.YAW);
      return point
          .flatMap(this::nedOf)
          .map(place -> seen.step(place, acceleration, turning, stepS()))
          .map(measured::orElse);
    }
    if (tuning.leans() && (state.phi().isEmpty() || state.theta().isEmpty())) {
      return Optional.empty(); // it would lean as if level, and overturn
    }
    Optional<BodyMotion> motion = BodyMotion.of(state, headingBefore, stepS());
    headingBefore = state.psi();
    return coasts ? motion.map(BodyMotion::withoutHorizontalVelocity) : motion;
  }

  /**
   * Whether the horizontal velocity is too uncertain to be controlled: the vehicle would accelerate
   * against an error.
   */
  private boolean isVelocityUnknown(StateInformation state) {
    double sigma = Math.max(state.xDotSigma().orElse(0.0), state.yDotSigma().orElse(0.0));
    return !tuning.leans() && sigma > UNKNOWN_SHARE * tuning.of(DegreeOfFreedom.SURGE).fastest();
  }

  private MotionTarget target(StateInformation state, Optional<NavigationPoint> point) {
    Optional<Point> way = wayToGo(state, point);
    if (way.isEmpty()) {
      return MotionTarget.none();
    }
    NavigationPoint to = point.orElseThrow();
    double headingThen = stateOf(to).orElseThrow().psi().orElse(0.0);
    return new MotionTarget(
        way,
        to.speed().isPresent() ? Optional.of(to.speed().getAsDouble()) : Optional.empty(),
        to.turn().isPresent()
            ? OptionalDouble.of(headingThen + to.turn().getAsDouble())
            : OptionalDouble.empty(),
        to.backwards());
  }

  private void drive(BodyMotion motion, MotionTarget target) {
    boolean stops = wasUnderWay && target.isStop() && !tuning.leans();
    wasUnderWay = !target.isStop();
    if (coasts || stops) {
      cascade.rest(DegreeOfFreedom.SURGE); // else their integrals would drive it on
      cascade.rest(DegreeOfFreedom.SWAY);
    }
    if (takesOver) {
      cascade.takeOver(motion, target, presentWrench());
      takesOver = false;
    }
    if (isAdrift) {
      HORIZONTAL.forEach(cascade::rest);
    }
    double[] wanted = cascade.step(motion, target, stepS());
    if (isAdrift) {
      HORIZONTAL.forEach(axis -> wanted[axis.ordinal()] = 0.0);
    }
    rememberWhetherItStands();
    double mass = tuning.of(tuner.axis()).mass();
    tuner
        .step(isArmedBySomebody && !wentBySight, left, wanted, cascade.measured(), mass, stepS())
        .ifPresent(words -> log(words));
    followCommands();
    allocator.allocate(wanted, stepS(), fluidMps);
    if (isSurgeLost && drivesOn()) {
      HORIZONTAL.forEach(axis -> wanted[axis.ordinal()] = 0.0);
      allocator.allocate(wanted, stepS(), fluidMps);
    }
    cascade.attained(allocator, stepS());
    tuner.tuned().ifPresent(cascade::rest);
    if (wentBySight) {
      response.restart();
    } else if (choices.get().watchesResponse() && tuner.tuned().isEmpty()) {
      watchResponse();
    }
    List<Effector> effectors = allocator.effectors();
    for (int i = 0; i < effectors.size(); i++) {
      String name = effectors.get(i).name();
      if (choices.get().commands() == CommandKind.FORCE
          && roster.commandTypes(name).contains(ForceCommand.TYPE.name())) {
        command(ForceCommand.of(name, allocator.forceN(i)), allocator.percent(i));
      } else {
        command(name, allocator.percent(i));
      }
    }
  }

  /**
   * Whether the allocation, for the sake of other axes, speeds up a vehicle that already moves
   * faster than wanted.
   */
  private boolean drivesOn() {
    double[] velocity = cascade.measured();
    int surge = DegreeOfFreedom.SURGE.ordinal();
    int sway = DegreeOfFreedom.SWAY.ordinal();
    double power =
        allocator.attained(DegreeOfFreedom.SURGE) * velocity[surge]
            + allocator.attained(DegreeOfFreedom.SWAY) * velocity[sway];
    return power > 0.0 && Math.hypot(velocity[surge], velocity[sway]) > cascade.wantedMps();
  }

  /**
   * Informs the allocator of the actual actuator commands: neutral, blended and a predecessor's
   * commands do not come from it, and it is recreated after each change of the configuration.
   */
  private void followCommands() {
    allocator
        .effectors()
        .forEach(each -> allocator.commanded(each.name(), lastCommand(each.name()).orElse(0.0)));
  }

  private void watchResponse() {
    List<DegreeOfFreedom> axes = new ArrayList<>();
    for (DegreeOfFreedom axis : left.axes()) {
      axes.add(axis);
      masses[axis.ordinal()] = tuning.of(axis).mass();
    }
    response
        .step(allocator, axes, cascade.measured(), masses, stepS())
        .ifPresent(
            found -> {
              log(
                  LogLevelEnum.WARN,
                  found.actuator()
                      + (found.left() > 0.0
                          ? " responds weakly: counted as weak for a time"
                          : " does not respond: excluded for a time"));
              weak.add(found, clock().micros() + Clock.micros(choices.get().retryTime()));
              revision = -1;
            });
  }

  /** Wrench of the last commands, including those of another control system. */
  private double[] presentWrench() {
    followCommands();
    return allocator.present(fluidMps);
  }

  /** Vector to the point: north, east, down [m]. */
  private Optional<Point> wayToGo(StateInformation state, Optional<NavigationPoint> point) {
    Optional<StateInformation> then = point.flatMap(this::stateOf);
    Optional<Point> ned = point.flatMap(this::nedOf);
    if (then.isEmpty() || ned.isEmpty()) {
      return Optional.empty();
    }
    return BodyMotion.displacement(then.get(), state)
        .map(gone -> ned.get().minus(gone))
        .map(way -> coasts ? Point.of(0.0, 0.0, way.z()) : way);
  }

  private void lookAtActuators() {
    long now = clock().micros();
    long newest = roster.revision(now);
    boolean isRetry = weak.forget(now);
    if (newest == revision && !isRetry) {
      return;
    }
    revision = newest;
    Map<String, Double> costs = Costs.parse(choices.get().costs());
    response.restart();
    allocator.use(
        weak.of(roster.present(now)), roster.sound(), each -> costs.getOrDefault(each.name(), 1.0));
    Set<DegreeOfFreedom> controlled = tuning.controlled();
    sound = Authority.of(roster.sound(), controlled);
    left = Authority.of(allocator.effectors(), controlled);
    cascade.steerage(allocator.steerageMps());
    List<DegreeOfFreedom> lost = left.lost(sound);
    lacksEssentials = Choices.axes(choices.get().essential()).stream().anyMatch(lost::contains);
    isSurgeLost = !tuning.leans() && lost.contains(DegreeOfFreedom.SURGE);
    // one thruster of two would drive it in circles, faster than it was to go
    isAdrift = isSurgeLost && lost.contains(DegreeOfFreedom.YAW) && !steers(allocator.effectors());
    List<String> gone = roster.lost(now);
    weak.lost().stream().filter(name -> !gone.contains(name)).forEach(gone::add);
    gone.forEach(name -> command(name, 0.0));
    say(left.words(sound), gone);
  }

  /** Whether effectors drive the vehicle without turning it, and turn it, if it may drift aside. */
  private boolean steers(List<Effector> effectors) {
    Set<DegreeOfFreedom> axes = EnumSet.of(DegreeOfFreedom.SURGE, DegreeOfFreedom.YAW);
    List<DegreeOfFreedom> lost =
        Authority.of(effectors, axes).lost(Authority.of(roster.sound(), axes));
    return !lost.contains(DegreeOfFreedom.SURGE) && !lost.contains(DegreeOfFreedom.YAW);
  }

  private void say(String authority, List<String> gone) {
    String words =
        (gone.isEmpty() ? "" : "lost: " + String.join(", ", gone) + "; ")
            + weak.words()
            + (authority.isEmpty() && !gone.isEmpty() ? "full authority is left" : authority)
            + (lacksEssentials
                ? "; actuators are neutral"
                : isAdrift ? "; horizontal thrust is off" : "");
    if (words.equals(said)) {
      return;
    }
    said = words;
    remark("authority", words);
    if (words.isEmpty()) {
      log(LogLevelEnum.INFO, "full control authority");
    } else {
      trouble(words);
    }
  }

  @Override
  protected void handOver(HandOver state) {
    super.handOver(state);
    cascade.handOver(state);
    if (wentBySight) {
      seen.transfer(Transfer.saving(state.text("BY SIGHT", "true")));
    }
  }

  @Override
  protected void takeOver(HandOver state) {
    boolean isMine = isOfMyClass(state);
    if (isMine) {
      cascade.takeOver(state, isSwap());
    }
    stood = cascade.stands();
    waits = stood && !isSwap(); // restarted in flight, its rotors must not stop
    if (!isSwap()) {
      return;
    }
    super.takeOver(state);
    takesOver = !isMine;
    if (isMine) {
      wentBySight = state.text("BY SIGHT").isPresent();
      seen.transfer(Transfer.restoring(state));
    }
  }

  @Override
  protected Map<String, Double> neutral() {
    Map<String, Double> neutral = new LinkedHashMap<>();
    allocator.effectors().forEach(each -> neutral.put(each.name(), 0.0));
    return neutral;
  }
}
