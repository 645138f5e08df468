package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.service.handover.HandOver;

/** Which of several causes decides, how long a cause counts, and what stays though it is gone. */
class FailsafeDecisionTest {
  private static final long SECOND = 1_000_000; // µs
  private static final String OVER = " (over; stays until armed again)";

  private static FailsafeDecision decision(Map<String, ?> values) {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", values);
    return new FailsafeDecision(
        configuration, configuration.settings(SafetyVariables.class), Hazard.STANDARD);
  }

  @Test
  void causes_ofSeveral_mostSevereIsFirstAndDecides() {
    FailsafeDecision decision = decision(Map.of("ON LOW BATTERY", "LAND"));
    decision.present(Hazard.POSITION, "lost", 0);
    decision.present(Hazard.LOW_BATTERY, "weak", 0);
    decision.present(Hazard.OPERATOR, "silent", 0);

    assertThat(decision.action()).isEqualTo(FailsafeAction.LAND);
    assertThat(decision.causes())
        .containsExactly("low battery: weak", "operator link: silent", "position: lost");
    assertThat(decision.hazards())
        .containsExactlyInAnyOrder(Hazard.OPERATOR, Hazard.POSITION, Hazard.LOW_BATTERY);
  }

  @Test
  void forget_goneForExactlyClearAfter_isOverAndNotAMicrosecondBefore() {
    FailsafeDecision decision = decision(Map.of("CLEAR AFTER", 3.0));
    decision.present(Hazard.POSITION, "lost", SECOND);

    decision.forgetUntil(4 * SECOND - 1);
    assertThat(decision.action()).isEqualTo(FailsafeAction.HOLD);
    decision.forgetUntil(4 * SECOND);
    assertThat(decision.action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(decision.causes()).isEmpty();
  }

  @Test
  void forget_clearAfterIsZero_causeThatIsThereNowCounts() {
    FailsafeDecision decision = decision(Map.of("CLEAR AFTER", 0.0));
    decision.present(Hazard.POSITION, "lost", SECOND);

    decision.forgetUntil(SECOND);
    assertThat(decision.action()).isEqualTo(FailsafeAction.HOLD);
    decision.forgetUntil(SECOND + 1);
    assertThat(decision.action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @ParameterizedTest
  @CsvSource({
    "ON POSITION LOSS, HOLD, false, CONTINUE",
    "ON POSITION LOSS, RETURN, false, RETURN",
    "ON POSITION LOSS, LAND, false, LAND",
    "ON POSITION LOSS, RETURN, true, CONTINUE",
    "ON FENCE, CONTINUE, false, CONTINUE",
    "ON FENCE, HOLD, false, HOLD",
    "ON FENCE, RETURN, true, RETURN"
  })
  void action_causeIsGone_staysFromReturnOnAndAtTheFenceInAnyCase(
      String variable, String action, boolean resume, FailsafeAction afterwards) {
    FailsafeDecision decision = decision(Map.of(variable, action, "RESUME", resume));
    Hazard hazard = variable.equals("ON FENCE") ? Hazard.FENCE : Hazard.POSITION;
    decision.present(hazard, "lost", 0);
    decision.forgetUntil(60 * SECOND);

    assertThat(decision.action()).isEqualTo(afterwards);
    assertThat(decision.causes())
        .isEqualTo(
            afterwards == FailsafeAction.CONTINUE
                ? List.of()
                : List.of(hazard.words() + ": lost" + OVER));
    decision.acknowledge();
    assertThat(decision.action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void causes_keptOneIsGoneAndAnotherIsThere_keptOneIsSaidFirst() {
    FailsafeDecision decision = decision(Map.of());
    decision.present(Hazard.OPERATOR, "silent", 0);
    decision.forgetUntil(60 * SECOND);
    decision.present(Hazard.POSITION, "lost", 60 * SECOND);

    assertThat(decision.causes()).containsExactly("operator link: silent" + OVER, "position: lost");
  }

  @Test
  void causes_twoOfTheSameSeverityAreGone_firstOneIsKept() {
    FailsafeDecision decision = decision(Map.of());
    decision.present(Hazard.OPERATOR, "silent", 0);
    decision.present(Hazard.LOW_BATTERY, "weak", 0);
    decision.forgetUntil(60 * SECOND);

    assertThat(decision.causes()).containsExactly("operator link: silent" + OVER);
  }

  @Test
  void causes_moreSevereOneComesLater_itIsKeptInstead() {
    FailsafeDecision decision = decision(Map.of("ON LOW BATTERY", "LAND"));
    decision.present(Hazard.OPERATOR, "silent", 0);
    decision.present(Hazard.LOW_BATTERY, "weak", 0);
    decision.present(Hazard.OPERATOR, "silent again", SECOND);
    decision.forgetUntil(60 * SECOND);

    assertThat(decision.causes()).containsExactly("low battery: weak" + OVER);
  }

  @Test
  void acknowledge_causeIsStillThere_countsOnlyWhenItIsPresentAgain() {
    FailsafeDecision decision = decision(Map.of());
    decision.present(Hazard.OPERATOR, "silent", 0);

    decision.acknowledge();
    assertThat(decision.action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(decision.causes()).isEmpty();
    decision.present(Hazard.OPERATOR, "silent", SECOND);
    assertThat(decision.action()).isEqualTo(FailsafeAction.RETURN);
  }

  private static FailsafeDecision successor(FailsafeDecision before, long nowMicros) {
    HandOver state = new HandOver("SafetyManager");
    before.handOver(state);
    FailsafeDecision successor = decision(Map.of());
    successor.takeOver(state, nowMicros);
    return successor;
  }

  @Test
  void takeOver_causeThatStaysAndIsGone_goesOnWithItAndSaysOverOnce() {
    FailsafeDecision before = decision(Map.of());
    before.present(Hazard.OPERATOR, "silent", 0);
    before.forgetUntil(60 * SECOND);
    FailsafeDecision second = successor(successor(before, 60 * SECOND), 61 * SECOND);

    assertThat(second.action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(second.causes()).containsExactly("operator link: silent" + OVER);
    assertThat(second.hazards()).isEmpty();
  }

  @Test
  void takeOver_severalCauses_allCountFromNowForClearAfter() {
    FailsafeDecision before = decision(Map.of("RESUME", true));
    before.present(Hazard.OPERATOR, "silent", 0);
    before.present(Hazard.POSITION, "lost", 0);
    FailsafeDecision second = successor(before, 60 * SECOND);

    second.forgetUntil(63 * SECOND - 1);
    assertThat(second.causes()).containsExactly("operator link: silent", "position: lost");
    second.forgetUntil(63 * SECOND);
    assertThat(second.action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void takeOver_causeOfAHazardThatItDoesNotKnow_ignoresIt() {
    HandOver state = new HandOver("SafetyManager");
    state.texts("causes", List.of("leak of another version", "RETURN", "2 cm"));
    FailsafeDecision decision = decision(Map.of());
    decision.takeOver(state, 0);

    assertThat(decision.action()).isEqualTo(FailsafeAction.CONTINUE);
  }
}
