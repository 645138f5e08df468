package org.u2sa.trials.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.StringWriter;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.u2sa.cli.command.ExitCode;

class ResultsTest {
  private static final List<Experiment> RUNS =
      Experiment.all(List.of("demo", "ugv"), 1, 3, List.of(Sweep.of("wind=\"calm, or so\",gusty")));

  private static Outcome outcome(int number, int exit, double missM, double wallS) {
    String summary =
        String.format(
            "{%n  \"seed\" : 1,%n  \"contacts\" : 0,%n  \"perWaypoint\" : [ { \"missM\" : %s }, { \"missM\" : 0.25 } ],%n"
                + "  \"obstacles\" : [ { \"leastDistanceM\" : 2.5 }, { \"leastDistanceM\" : 1.5 } ],%n  \"wallSeconds\" : %s,%n"
                + "  \"simSecondsPerSecond\" : %s%n}",
            missM, wallS, 100.0 / wallS);
    return new Outcome(RUNS.get(number - 1), exit, summary, "");
  }

  private final Outcome good = outcome(1, ExitCode.DONE, 0.5, 10.0);
  private final Outcome wide = outcome(2, ExitCode.DONE, 1.5, 11.0);
  private final Outcome failed = outcome(3, ExitCode.FAILED, 0.4, 12.0);
  private final Outcome lost = new Outcome(RUNS.get(3), RunAnswer.LOST, "", "its process has died");
  private final Results results = new Results(List.of(failed, lost, good, wide), "worstMissM");

  @Test
  void figures_summary_areItsNumbersWithoutTheMachines() {
    assertThat(wide.figures())
        .containsOnlyKeys("contacts", "worstMissM", "leastDistanceM")
        .containsEntry("worstMissM", 1.5)
        .containsEntry("leastDistanceM", 1.5);
    assertThat(lost.figures()).isEmpty();
  }

  @Test
  void worst_runs_areFailuresFirstThenByTheRankingFigure() {
    assertThat(results.worst(3)).containsExactly(failed, lost, wide);
    assertThat(results.succeeded()).isEqualTo(2);
    assertThat(results.share()).isEqualTo("50.0 %");
  }

  @Test
  void hash_otherOrderAndSpeed_isTheSame() {
    Results faster =
        new Results(List.of(lost, outcome(2, ExitCode.DONE, 1.5, 1.0), good, failed), "contacts");

    assertThat(faster.hash()).isEqualTo(results.hash());
  }

  @Test
  void hash_anyOtherResult_isAnother() {
    Results other =
        new Results(
            List.of(outcome(1, ExitCode.DONE, 0.500001, 10.0), wide, failed, lost), "worstMissM");
    Results exit =
        new Results(
            List.of(outcome(1, ExitCode.FAILED, 0.5, 10.0), wide, failed, lost), "worstMissM");

    assertThat(other.hash()).isNotEqualTo(results.hash());
    assertThat(exit.hash()).isNotEqualTo(results.hash());
  }

  @Test
  void writeCsv_missingFigureAndCellWithComma_areEmptyAndQuoted() throws IOException {
    StringWriter csv = new StringWriter();
    new Results(List.of(good, lost), "worstMissM").writeCsv(csv);

    assertThat(csv.toString().lines())
        .containsExactly(
            "run,seed,wind,success,contacts,leastDistanceM,worstMissM",
            "1,1,\"\"\"calm\",true,0.0,1.5,0.5",
            "4,1,\"or so\"\"\",false,,,");
  }

  @Test
  void quantile_fewValues_liesBetweenTheNearestAsInNumpy() {
    Distribution spread = Distribution.of(DoubleStream.of(3.0, 1.0, 2.0, 10.0));

    assertThat(spread.median()).isEqualTo(2.5);
    assertThat(spread.quantile(0.95)).isEqualTo(8.95, within(1e-12)); // numpy.quantile
    assertThat(spread.quantile(1.0)).isEqualTo(10.0);
    assertThat(spread.mean()).isEqualTo(4.0);
  }

  @Test
  void of_page_showsTextsOfRunsAsText() {
    Outcome marked = new Outcome(RUNS.get(0), ExitCode.FAILED, "", "<script>alert(1)</script>");

    String page = CampaignPage.of("a & b", new Results(List.of(marked), "x"), List.of(), 5);

    assertThat(page).contains("&lt;script&gt;").doesNotContain("<script").contains("a &amp; b");
  }

  @Test
  void of_outputThatIsHalfASummary_isTroubleWithoutFigures() {
    Outcome outcome = Outcome.of(RUNS.get(0), new RunAnswer(ExitCode.FAILED, "{\"a\": 1,", "died"));

    assertThat(outcome.summary()).isEmpty();
    assertThat(outcome.figures()).isEmpty();
    assertThat(outcome.trouble()).contains("died");
  }
}
