package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.service.handover.HandOver;

/**
 * When a vehicle is too near to a fence of 200 m by 200 m around the origin, from 50 m to 150 m of
 * altitude. It needs 1 s to react, brakes with 2 m/s², and ends a climb or descent with 1 m/s².
 */
class FenceWatchTest {
  private static final String FENCE =
      """
      <fence>
        <reference>Local ENU</reference>
        <floor>50</floor>
        <ceiling>150</ceiling>
        <keepIn>
          <corner><x>-100</x><y>-100</y></corner>
          <corner><x>100</x><y>-100</y></corner>
          <corner><x>100</x><y>100</y></corner>
          <corner><x>-100</x><y>100</y></corner>
        </keepIn>
      </fence>
      """;

  @TempDir private Path folder;
  private Path file;
  private final Map<String, Object> variables = new HashMap<>();
  private PositionWatch states;

  @BeforeEach
  void write() throws IOException {
    file = Files.writeString(folder.resolve("fence.xml"), FENCE);
    variables.put("FENCE", file.toString());
    variables.put("REACTION TIME", 1.0);
    variables.put("BRAKING", 2.0);
    variables.put("VERTICAL ACCELERATION", 1.0);
  }

  private FenceWatch watch() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", variables);
    Supplier<SafetyVariables> settings = configuration.settings(SafetyVariables.class);
    states = new PositionWatch(settings);
    return new FenceWatch(
        configuration, settings, new FenceFile(configuration, new LockstepClock()), states);
  }

  /** A state between floor and ceiling. */
  private static StateInformation at(double x, double y) {
    return flat(x, y).z(100.0);
  }

  /** A state without an altitude. */
  private static StateInformation flat(double x, double y) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
    state.x(x).y(y).timestamp(0L);
    return state;
  }

  private FenceWatch seeing(StateInformation state) {
    FenceWatch watch = watch();
    states.see(state, 0);
    return watch;
  }

  @Test
  void trouble_standsExactlyOnTheEdge_isInsideAndOneCentimetreBeyondOutside() {
    assertThat(seeing(at(100.0, 0.0)).trouble(0)).isEmpty();
    assertThat(seeing(at(100.0, 0.0)).objection(0)).isEmpty();

    assertThat(seeing(at(100.01, 0.0)).trouble(0)).contains("outside");
    assertThat(seeing(at(100.01, 0.0)).objection(0))
        .contains("outside the keep-in area, or inside a keep-out one");
  }

  /** At 8 m/s: 8 m until it reacts and 16 m of braking. */
  @Test
  void trouble_comesToStandExactlyOnTheEdge_isNoneAndOneCentimetreLaterItIs() {
    assertThat(seeing(at(76.0, 0.0).xDot(8.0)).trouble(0)).isEmpty();
    assertThat(seeing(at(76.01, 0.0).xDot(8.0)).trouble(0))
        .contains("too near to stop within 24 m");
    assertThat(seeing(at(0.0, -76.01).yDot(-8.0)).trouble(0))
        .contains("too near to stop within 24 m");
    assertThat(seeing(at(76.01, 0.0).xDot(8.0)).objection(0)).as("armed on its way").isEmpty();
  }

  /**
   * At 8 m/s: 24 m to stop, and 0.5 m/s of drift in 4 s of braking and 6 s more. Without an
   * allowance the way is that of still water.
   */
  @Test
  void trouble_driftingVehicleWithWindAllowance_isEarlierByItsDrift() {
    variables.put("WIND ALLOWANCE", 0.5);
    variables.put("DRIFT TIME", 6.0);

    assertThat(seeing(at(70.9, 0.0).xDot(8.0)).trouble(0)).isEmpty();
    assertThat(seeing(at(71.01, 0.0).xDot(8.0)).trouble(0))
        .contains("too near to stop within 29 m");
    assertThat(seeing(at(0.0, 95.5).xDot(8.0)).trouble(0)).as("drift aside").isPresent();
    assertThat(seeing(at(0.0, 99.9).yDot(-8.0)).trouble(0)).as("it leaves the fence").isEmpty();
    assertThat(seeing(at(99.9, 0.0).xDot(0.05)).trouble(0)).as("it stands").isEmpty();
  }

  /** Eastward at 8 m/s over ground, of which 7 m/s through the water. */
  @Test
  void trouble_driftsFasterThanTheAllowance_countsWhatTheStateShows() {
    variables.put("WIND ALLOWANCE", 0.5);
    variables.put("DRIFT TIME", 6.0);
    StateInformation near = at(70.9, 0.0).xDot(8.0).yDot(0.0).psi(0.0);

    assertThat(seeing(near.copy().fluidxDot(7.6)).trouble(0)).as("0.4 m/s").isEmpty();
    assertThat(seeing(near.copy().fluidxDot(7.0)).trouble(0))
        .contains("too near to stop within 34 m");

    variables.put("WIND ALLOWANCE", 0.0);
    assertThat(seeing(near.copy().fluidxDot(7.0)).trouble(0)).as("holds at once").isEmpty();
  }

  /** Beyond them the region had no coordinates, and nothing was outside. */
  @ParameterizedTest
  @CsvSource({
    "TURN, WIND ALLOWANCE, 1e12, 1e308",
    "TURN TO ONE SIDE, WIND ALLOWANCE, 1e12, 1e308",
    "TURN, HOLD RADIUS, 1e12, 1e308",
    "TURN TO ONE SIDE, HOLD RADIUS, 1e12, 1e308",
  })
  void trouble_mostRoomThatCanBeConfigured_isTooNearAndMoreIsRefused(
      String manoeuvre, String variable, double most, double more) {
    variables.put("FENCE MANOEUVRE", manoeuvre);
    variables.put("ON FENCE", "HOLD");
    variables.put(variable, most);
    assertThat(seeing(at(0.0, 0.0).xDot(3.0).yDot(-7.0)).trouble(0)).isPresent();

    variables.put(variable, more);
    assertThatThrownBy(this::watch).hasMessageContaining("neither 0 nor of a magnitude");
  }

  /** At 6 and 8 m/s, so 10 m/s: 20 m until it reacts after 2 s, and 25 m of braking. */
  @Test
  void trouble_goesAslantAndReactsSlowly_saysTheWayOfItsWholeSpeed() {
    variables.put("REACTION TIME", 2.0);

    assertThat(seeing(at(90.0, 0.0).xDot(6.0).yDot(8.0)).trouble(0))
        .contains("too near to stop within 45 m");
  }

  /** At 20 m/s and 45° of bank: v²/g is 41 m. */
  @Test
  void trouble_turnsAndIsTooNear_saysItsRadius() {
    variables.put("FENCE MANOEUVRE", "TURN");
    variables.put("TURN BANK", Math.PI / 4.0);

    assertThat(seeing(at(60.0, 0.0).xDot(16.0).yDot(12.0)).trouble(0))
        .contains("too near to turn with a radius of 41 m");
  }

  /** Northward at 20 m/s and 45° of bank half a turn needs 82 m to one side, 41 m ahead. */
  @ParameterizedTest
  @CsvSource({
    "TURN, 60, 0, false",
    "TURN TO ONE SIDE, 60, 0, true",
    "TURN TO ONE SIDE, 0, 60, false"
  })
  void trouble_fliesAlongTheFence_isNoneIfRoomOnOneSideIsEnough(
      String manoeuvre, double eastM, double northM, boolean well) {
    variables.put("FENCE MANOEUVRE", manoeuvre);
    variables.put("TURN BANK", Math.PI / 4.0);

    assertThat(seeing(at(eastM, northM).yDot(20.0)).trouble(0).isEmpty()).isEqualTo(well);
  }

  /** It looks closely only where the fence may be within reach; with a new fence it does so. */
  @ParameterizedTest
  @CsvSource({"TURN", "TURN TO ONE SIDE", "BRAKE"})
  void trouble_onItsWay_isThatOfAWatchThatSeesItForTheFirstTime(String manoeuvre) {
    variables.put("FENCE MANOEUVRE", manoeuvre);
    FenceWatch going = watch();
    PositionWatch seen = states;
    FenceWatch close = watch();
    Optional<GivenFence> fence = close.configured();
    for (double x = -110.0; x <= 110.0; x += 0.5) {
      StateInformation state = at(x, 0.4 * x).xDot(4.0).yDot(1.6);
      seen.see(state, 0);
      states.see(state, 0);
      close.order(fence);
      assertThat(going.trouble(0)).as("at %s m", x).isEqualTo(close.trouble(0));
    }
  }

  /** Climbing with 4 m/s: 4 m until it reacts, and 8 m until the climb ends. */
  @ParameterizedTest
  @CsvSource({
    "150.0, 0.0, true",
    "150.1, 0.0, false",
    "150.1, -1.0, false",
    "138.0, 4.0, true",
    "138.1, 4.0, false"
  })
  void trouble_atTheCeiling_isNoneUntilItWouldRiseAboveIt(
      double altitudeM, double upMps, boolean well) {
    FenceWatch watch = seeing(at(0.0, 0.0).z(altitudeM).zDot(upMps));

    assertThat(watch.trouble(0))
        .isEqualTo(
            well
                ? Optional.empty()
                : Optional.of("ceiling 150 m at " + CauseText.metres(altitudeM)));
  }

  @ParameterizedTest
  @CsvSource({
    "50.0, 0.0, true",
    "49.9, 0.0, false",
    "49.9, 4.0, false",
    "62.0, -4.0, true",
    "61.9, -4.0, false"
  })
  void trouble_atTheFloorOnceAboveIt_isNoneUntilItWouldSinkBelowIt(
      double altitudeM, double upMps, boolean well) {
    FenceWatch watch = seeing(at(0.0, 0.0).z(100.0));
    assertThat(watch.trouble(0)).isEmpty();
    states.see(at(0.0, 0.0).z(altitudeM).zDot(upMps), 0);

    assertThat(watch.trouble(0))
        .isEqualTo(
            well ? Optional.empty() : Optional.of("floor 50 m at " + CauseText.metres(altitudeM)));
  }

  @Test
  void trouble_belowTheFloorBeforeItWasAbove_isNoneAndExactlyAtItCountsAsAbove() {
    FenceWatch watch = seeing(at(0.0, 0.0).z(0.0));
    assertThat(watch.trouble(0)).as("before it takes off").isEmpty();
    states.see(at(0.0, 0.0).z(50.0), 0);
    assertThat(watch.trouble(0)).isEmpty();

    states.see(at(0.0, 0.0).z(49.0), 0);

    assertThat(watch.trouble(0)).contains("floor 50 m at 49 m");
  }

  @Test
  void takeOver_hasBeenAboveTheFloor_stillCounts() {
    FenceWatch before = seeing(at(0.0, 0.0).z(50.0));
    assertThat(before.saved()).isEqualTo("false");
    assertThat(before.trouble(0)).isEmpty();
    assertThat(before.saved()).isEqualTo("true");
    HandOver state = new HandOver("SafetyManager");
    before.handOver(state, 0);
    FenceWatch successor = seeing(at(0.0, 0.0).z(49.0));
    successor.takeOver(state, 0, false);

    assertThat(successor.trouble(0)).contains("floor 50 m at 49 m");
  }

  /** As with a position: at once, while the state is fresh. */
  @ParameterizedTest
  @CsvSource({"true, true", "true, false", "false, true"})
  void trouble_altitudeLimitedButNotKnown_isSaidAndAgainstArming(boolean floor, boolean ceiling)
      throws IOException {
    String lower = floor ? FENCE : FENCE.replace("<floor>50</floor>", "");
    Files.writeString(file, ceiling ? lower : lower.replace("<ceiling>150</ceiling>", ""));
    FenceWatch watch = seeing(at(0.0, 0.0));
    assertThat(watch.trouble(0)).isEmpty();
    assertThat(watch.objection(0)).isEmpty();
    states.see(flat(0.0, 0.0), 0);

    assertThat(watch.trouble(0)).contains("cannot be watched: no altitude");
    assertThat(watch.objection(0)).contains("no altitude");
    assertThat(watch.trouble(10_000_000)).as("an old state is not the fence's").isEmpty();
    states.see(at(0.0, 0.0), 0);
    assertThat(watch.trouble(0)).isEmpty();
  }

  @Test
  void trouble_altitudeNotKnownAndOutside_isOutside() {
    assertThat(seeing(flat(100.01, 0.0)).trouble(0)).contains("outside");
    assertThat(seeing(flat(100.01, 0.0)).objection(0))
        .contains("outside the keep-in area, or inside a keep-out one");
  }

  @Test
  void trouble_altitudeNeitherKnownNorLimited_isJudgedByPlaceAlone() throws IOException {
    Files.writeString(
        file, FENCE.replace("<floor>50</floor>", "").replace("<ceiling>150</ceiling>", ""));

    assertThat(seeing(flat(0.0, 0.0)).trouble(0)).isEmpty();
    assertThat(seeing(flat(0.0, 0.0)).objection(0)).isEmpty();
  }

  @Test
  void trouble_neitherFloorNorCeiling_anyAltitudeWillDo() throws IOException {
    Files.writeString(
        file, FENCE.replace("<floor>50</floor>", "").replace("<ceiling>150</ceiling>", ""));
    FenceWatch watch = seeing(at(0.0, 0.0).z(100.0));
    assertThat(watch.trouble(0)).isEmpty();
    states.see(at(0.0, 0.0).z(-1000.0), 0);
    assertThat(watch.trouble(0)).isEmpty();
    states.see(at(0.0, 0.0).z(10_000.0), 0);

    assertThat(watch.trouble(0)).isEmpty();
  }

  @Test
  void trouble_noPositionOrAnOldOneOrNoFence_isNotTheFences() {
    StateInformation half = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
    half.x(500.0).timestamp(0L);
    assertThat(seeing(half).trouble(0)).isEmpty();
    assertThat(seeing(at(500.0, 0.0)).trouble(10_000_000)).isEmpty();
    assertThat(watch().objection(0)).isEmpty();

    variables.put("FENCE", "");
    assertThat(seeing(at(500.0, 0.0)).trouble(0)).isEmpty();
    assertThat(watch().fence()).isEmpty();
  }

  @Test
  void trouble_landedDisarmedAndArmedAnew_mayTakeOffAgain() {
    FenceWatch watch = seeing(at(0.0, 0.0).z(100.0));
    assertThat(watch.trouble(0)).isEmpty();
    states.see(at(0.0, 0.0).z(0.0), 0);
    assertThat(watch.trouble(0)).contains("floor 50 m at 0 m");

    watch.see(new ArmingState().armed(true), 0);
    assertThat(watch.trouble(0)).contains("floor 50 m at 0 m");
    watch.see(new ArmingState().armed(false), 0);
    watch.see(new ArmingState().armed(true), 0);

    assertThat(watch.trouble(0)).isEmpty();
  }

  /** As when another fence is set in flight: the other watches must go on all the same. */
  @Test
  void trouble_stateDoesNotFitTheFence_isSaid() {
    StateInformation state = at(0.0, 0.0).referenceFrame(ReferenceFrame.GLOBAL);

    assertThat(seeing(state).trouble(0))
        .contains("a state in GLOBAL does not fit a fence on a local plane");
    assertThat(seeing(state).objection(0))
        .contains("a state in GLOBAL does not fit a fence on a local plane");
  }
}
