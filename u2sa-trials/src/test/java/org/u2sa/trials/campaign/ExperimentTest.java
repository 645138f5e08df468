package org.u2sa.trials.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

class ExperimentTest {
  private static final List<String> BASE = List.of("demo", "ugv", "--loops", "1");

  @Test
  void all_noSweep_isOneEachSeed() {
    List<Experiment> all = Experiment.all(BASE, 7, 3, List.of());

    assertThat(all).extracting(Experiment::number).containsExactly(1, 2, 3);
    assertThat(all).extracting(Experiment::seed).containsExactly(7L, 8L, 9L);
    assertThat(all.get(1).arguments())
        .containsExactly("demo", "ugv", "--loops", "1", "--seed", "8");
  }

  @Test
  void all_twoSweeps_areAllCombinationsWithTheSameSeeds() {
    List<Experiment> all =
        Experiment.all(BASE, 1, 2, List.of(Sweep.of("a=1,2"), Sweep.of("S:B=x,y,z")));

    assertThat(all).hasSize(12);
    assertThat(all).extracting(Experiment::arguments).doesNotHaveDuplicates();
    assertThat(all.get(3).factors()).containsEntry("a", "1").containsEntry("S:B", "y");
    assertThat(all.get(11).factors()).containsEntry("a", "2").containsEntry("S:B", "z");
    assertThat(all.get(11).seed()).isEqualTo(2);
  }

  @Test
  void command_wordsThatAShellWouldSplit_areQuoted() {
    Experiment one = Experiment.all(BASE, 1, 1, List.of(Sweep.of("S:LOOK AHEAD=it's"))).get(0);

    assertThat(one.command())
        .isEqualTo("./u2sa demo ugv --loops 1 --set 'S:LOOK AHEAD=it'\\''s' --seed 1");
  }
}
