package org.u2sa.scenarios.encounters;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Right of way in the published cases, and in variations of them. */
class PublishedEncountersTest {
  /** Variations of each case; more with {@code -Du2sa.encounters=50}. */
  private static final int SEEDS = Integer.getInteger("u2sa.encounters", 2);

  private static final int MOST_MANOEUVRES = 4;

  static List<EncounterCase> cases() {
    return EncounterCase.all();
  }

  @Test
  void all_cases_areTheBaseCasesAndImazus() {
    assertThat(cases()).hasSize(55 + 22);
    assertThat(cases()).allMatch(each -> each.vessels().size() <= 3);
    assertThat(cases().get(0).vessels().get(0).closestS()).isBetween(140.0, 160.0);
  }

  @ParameterizedTest
  @MethodSource("cases")
  void decide_publishedCase_isResolvedByItsRules(EncounterCase each) {
    SteeredBoat boat = new SteeredBoat(each, 0.0, 1L);
    EncounterScore score = boat.run();

    assertThat(score.violations()).as(String.join("\n", score.lines())).isEmpty();
    assertThat(boat.manoeuvres()).isLessThanOrEqualTo(MOST_MANOEUVRES);
  }

  @Test
  void decide_variations_areResolvedByTheirRules() {
    List<String> broken = new ArrayList<>();
    for (EncounterCase base : cases()) {
      for (long seed = 1; seed <= SEEDS; seed++) {
        EncounterCase each = base.varied(seed);
        EncounterScore score = new SteeredBoat(each, 1.5, seed).run();
        score.violations().forEach(what -> broken.add(each.name() + ": " + what));
      }
    }

    assertThat(broken).isEmpty();
  }
}
