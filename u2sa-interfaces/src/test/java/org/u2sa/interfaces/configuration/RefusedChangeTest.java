package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.contract.ConfigurationAssignment;

/** How much may be asked of a configuration at once, and how much of it the answer repeats. */
class RefusedChangeTest {
  private final XmlConfiguration configuration =
      XmlConfiguration.inMemory("test", Map.of("NAME", "x"));

  private ConfigurationOutcome change(Map<String, ?> wanted) {
    return configuration.change(
        wanted, OptionalLong.empty(), new ChangeOrigin(0, "Test", "ann"), ConfigurationCheck.NONE);
  }

  private static Map<String, String> many(int count) {
    Map<String, String> many = new LinkedHashMap<>();
    for (int i = 0; i < count; i++) {
      many.put("V" + i, "1");
    }
    return many;
  }

  @Test
  void change_oneVariableTooMany_isRefusedBeforeAnyIsLookedAt() {
    assertThat(change(many(257)).refusal())
        .contains("test: 257 variables in one change, expected at most 256");
    assertThat(change(many(256)).refusal())
        .hasValueSatisfying(why -> assertThat(why).startsWith("test, variable \"V0\": not found"));
  }

  @Test
  void change_valueOfTheGreatestLength_isAcceptedAndALongerOneIsNot() {
    assertThat(change(Map.of("NAME", "y".repeat(2_000))).accepted()).isTrue();

    ConfigurationOutcome longer = change(Map.of("NAME", "z".repeat(2_001)));

    assertThat(longer.accepted()).isFalse();
    assertThat(longer.refusal())
        .contains("test, variable \"NAME\": 2001 characters, expected 2000 at most");
    assertThat(configuration.getVariable("NAME")).isEqualTo("y".repeat(2_000));
  }

  @Test
  void change_nameOfMoreThanTheGreatestLength_isRefusedAndShownShort() {
    assertThat(change(Map.of("N".repeat(2_001), "1")).refusal())
        .contains(
            "test, variable \"" + "N".repeat(200) + "…\": 2001 characters, expected 2000 at most");
  }

  @Test
  void change_refused_answersWithWhatWasAskedForUpToSixteen() {
    assertThat(change(many(17)).assignments())
        .hasSize(16)
        .last()
        .isEqualTo(new ConfigurationAssignment().variableName("V15").value("1"));
  }

  @Test
  void change_refusedLongTexts_areCutOffBehindTwoHundredCharacters() {
    Map<String, String> wanted = new LinkedHashMap<>();
    wanted.put("A".repeat(200), "b".repeat(201));

    assertThat(change(wanted).assignments())
        .containsExactly(
            new ConfigurationAssignment()
                .variableName("A".repeat(200))
                .value("b".repeat(200) + "…"));
  }

  @Test
  void refuse_withoutLooking_saysTheReasonAndChangesNothing() {
    change(Map.of("NAME", "y"));

    WrittenChange refused = configuration.refuse("too many");

    assertThat(refused.outcome().refusal()).contains("too many");
    assertThat(refused.outcome().revision()).isOne();
    assertThat(refused.takeEffect()).isSameAs(refused.outcome());
    assertThat(configuration.getVariable("NAME")).isEqualTo("y");
  }
}
