package org.u2sa.trials.campaign;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.report.EscapedXml;
import org.u2sa.report.picture.FigureChart;

/** The report of a campaign as a self-contained HTML page. */
final class CampaignPage {
  private static final String STYLE =
      """
      body { font: 16px/1.5 system-ui, sans-serif; color: #1d2430; max-width: 1120px; margin: 2em auto; padding: 0 1em }
      table { border-collapse: collapse; margin: 1em 0 } th, td { padding: .25em .8em; text-align: right; border-bottom: 1px solid #dfe3e9 }
      th:first-child, td:first-child, .text { text-align: left } code { background: #f6f7f9; padding: .1em .3em }
      .bad { color: #b54a00; font-weight: bold } .good { color: #00795a; font-weight: bold } img { max-width: 100%; margin: .5em 1em .5em 0 }
      """;

  private final StringBuilder page = new StringBuilder();
  private final Results results;
  private final Map<String, Distribution> spreads;

  private CampaignPage(Results results) {
    this.results = results;
    spreads = results.spreads();
  }

  /**
   * @param campaign textual description of the campaign
   * @param sweeps the parameters that were swept
   * @param worst number of worst runs to list
   */
  static String of(String campaign, Results results, List<Sweep> sweeps, int worst) {
    return new CampaignPage(results).whole(campaign, sweeps, worst);
  }

  private String whole(String campaign, List<Sweep> sweeps, int worst) {
    page.append("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>")
        .append(EscapedXml.of(campaign))
        .append("</title><style>")
        .append(STYLE)
        .append("</style></head><body>\n<h1>")
        .append(EscapedXml.of(campaign))
        .append("</h1>\n<p><span class=\"")
        .append(results.succeeded() == results.outcomes().size() ? "good" : "bad")
        .append("\">")
        .append(results.succeeded() + " of " + results.outcomes().size())
        .append("</span> runs succeeded (")
        .append(results.share())
        .append("). SHA-256 of the results: <code>")
        .append(results.hash())
        .append("</code></p>\n");
    figures();
    worst(worst);
    sweeps.forEach(this::sweep);
    histograms();
    return page.append("</body></html>\n").toString();
  }

  private void figures() {
    page.append("<h2>Figures</h2>\n<table><tr><th>figure</th><th>runs</th><th>minimum</th>")
        .append("<th>median</th><th>mean</th><th>95 %</th><th>maximum</th></tr>\n");
    spreads.forEach(
        (name, spread) ->
            row(
                EscapedXml.of(name),
                Integer.toString(spread.values().length),
                number(spread.least()),
                number(spread.median()),
                number(spread.mean()),
                number(spread.quantile(0.95)),
                number(spread.greatest())));
    page.append("</table>\n");
  }

  private void worst(int most) {
    page.append("<h2>Worst runs</h2>\n<p>Failed runs first, then by <code>")
        .append(EscapedXml.of(results.ranking()))
        .append("</code>. The command repeats the run, with pictures.</p>\n<table>")
        .append("<tr><th>run</th><th>")
        .append(EscapedXml.of(results.ranking()))
        .append("</th><th class=\"text\">result</th><th class=\"text\">command</th></tr>\n");
    for (Outcome outcome : results.worst(most)) {
      page.append("<tr><td>")
          .append(outcome.experiment().number())
          .append("</td><td>")
          .append(figure(outcome))
          .append("</td><td class=\"text\">")
          .append(outcome.success() ? "success" : "<span class=\"bad\">failed</span> ")
          .append(EscapedXml.of(outcome.trouble()))
          .append("</td><td class=\"text\"><code>")
          .append(EscapedXml.of(outcome.experiment().command()))
          .append("</code></td></tr>\n");
    }
    page.append("</table>\n");
  }

  private String figure(Outcome outcome) {
    return outcome.figure(results.ranking()).isPresent()
        ? number(outcome.figure(results.ranking()).getAsDouble())
        : "–";
  }

  /** Success rate and ranking figure for each value of a parameter. */
  private void sweep(Sweep sweep) {
    page.append("<h2>By ")
        .append(EscapedXml.of(sweep.name()))
        .append("</h2>\n<table><tr><th>value</th>")
        .append("<th>runs</th><th>succeeded</th><th>median</th><th>maximum</th></tr>\n");
    Map<String, double[]> byValue = new LinkedHashMap<>();
    for (String value : sweep.values()) {
      List<Outcome> runs = new ArrayList<>();
      for (Outcome outcome : results.outcomes()) {
        if (outcome.experiment().factors().get(sweep.name()).equals(value)) {
          runs.add(outcome);
        }
      }
      double[] figures =
          runs.stream().flatMapToDouble(run -> run.figure(results.ranking()).stream()).toArray();
      boolean known = figures.length > 0;
      Distribution spread = Distribution.of(Arrays.stream(figures));
      row(
          EscapedXml.of(value),
          Integer.toString(runs.size()),
          Long.toString(runs.stream().filter(Outcome::success).count()),
          known ? number(spread.median()) : "–",
          known ? number(spread.greatest()) : "–");
      if (known) {
        byValue.put(value, figures);
      }
    }
    page.append("</table>\n");
    if (!byValue.isEmpty()) {
      picture(FigureChart.dependence(results.ranking(), sweep.name(), byValue));
    }
  }

  private void histograms() {
    page.append("<h2>Distributions</h2>\n");
    spreads.forEach(
        (name, spread) -> {
          if (!spread.isConstant()) {
            picture(FigureChart.histogram(name, spread.values()));
          }
        });
  }

  private void picture(String svg) {
    page.append("<img alt=\"\" src=\"data:image/svg+xml;base64,")
        .append(Base64.getEncoder().encodeToString(svg.getBytes(StandardCharsets.UTF_8)))
        .append("\">\n");
  }

  private void row(String... cells) {
    page.append("<tr>");
    for (String cell : cells) {
      page.append("<td>").append(cell).append("</td>");
    }
    page.append("</tr>\n");
  }

  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e9
        ? String.format(Locale.ROOT, "%.0f", value)
        : String.format(Locale.ROOT, "%.3f", value);
  }
}
