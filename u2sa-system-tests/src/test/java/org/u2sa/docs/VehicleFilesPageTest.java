package org.u2sa.docs;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.u2sa.sim.file.VehicleFile;
import org.u2sa.sim.file.element.Presets;

/** The tables of docs/vehicle-files.md against what the reader asks for. */
class VehicleFilesPageTest {
  private static final Pattern EXAMPLE = Pattern.compile("```xml\n(.*?)```", Pattern.DOTALL);
  private static final Pattern SECTION =
      Pattern.compile("### `(\\w+)`[^\n]*\n(.*?)(?=\n##)", Pattern.DOTALL);
  private static final Pattern ROW = Pattern.compile("(?m)^\\| (`.*?) \\|");
  private static final Pattern NAME = Pattern.compile("`(\\w+)`");
  private static final Pattern ASKED = Pattern.compile("; expected ([\\w, ]+)");

  private final Page page = new Page("docs/vehicle-files.md");

  private List<String> vehicles() throws IOException {
    List<String> vehicles = new ArrayList<>();
    EXAMPLE.matcher(page.text()).results().forEach(each -> vehicles.add(each.group(1)));
    vehicles.add(new Page("config/ugv/vehicle.xml").text());
    vehicles.add(new Page("config/ugv/vehicle-ackermann.xml").text());
    vehicles.add(new Page("config/vehicles/bluerov2.xml").text());
    vehicles.add(new Page("config/cessna/vehicle.xml").text());
    vehicles.add(new Page("config/vehicles/remus100.xml").text());
    vehicles.add(new Page("config/robosub/vehicle.xml").text());
    vehicles.add(new Page("config/vehicles/trainer.xml").text());
    return vehicles;
  }

  private static void read(String text) {
    String origin = Page.ROOT.resolve("config/vehicles/vehicle.xml").toString();
    VehicleFile.read(new ByteArrayInputStream(text.getBytes(UTF_8)), origin);
  }

  /** Names that the reader asks an element for, in any of the vehicles. */
  private static TreeSet<String> asked(String element, List<String> vehicles) {
    TreeSet<String> asked = new TreeSet<>();
    Pattern empty = Pattern.compile("<" + element + "( [^>]*)?/>");
    Pattern open = Pattern.compile("<" + element + "( [^>]*[^>/])?>");
    for (String vehicle : vehicles) {
      String wrong =
          open.matcher(
                  empty
                      .matcher(vehicle)
                      .replaceFirst(
                          Matcher.quoteReplacement("<" + element) + "$1></" + element + ">"))
              .replaceFirst("$0<zzz/>");
      if (wrong.contains("<zzz/>")) {
        Matcher message = ASKED.matcher(catchThrowable(() -> read(wrong)).getMessage());
        assertThat(message.find()).as(element).isTrue();
        asked.addAll(List.of(message.group(1).split(", ")));
      }
    }
    return asked;
  }

  @Test
  void examples_ofThePage_areVehicles() throws IOException {
    assertThat(vehicles()).hasSize(12).allSatisfy(VehicleFilesPageTest::read);
  }

  @Test
  void tables_ofThePage_nameWhatTheReaderAsksFor() throws IOException {
    List<MatchResult> sections = SECTION.matcher(page.text()).results().toList();
    assertThat(sections).hasSizeGreaterThan(20);
    Map<String, TreeSet<String>> documented = new LinkedHashMap<>(); // an element may have several
    for (MatchResult section : sections) {
      TreeSet<String> names =
          documented.computeIfAbsent(section.group(1), element -> new TreeSet<>());
      ROW.matcher(section.group(2))
          .results()
          .flatMap(row -> NAME.matcher(row.group(1)).results())
          .forEach(name -> names.add(name.group(1)));
    }
    for (Map.Entry<String, TreeSet<String>> each : documented.entrySet()) {
      assertThat(each.getValue())
          .as("table of <%s> in docs/vehicle-files.md", each.getKey())
          .isEqualTo(asked(each.getKey(), vehicles()));
    }
  }

  @Test
  void presets_ofThePage_areThoseOfTheReader() throws IOException {
    Map<String, List<String>> byElement = new LinkedHashMap<>();
    Presets.all()
        .forEach(
            each ->
                byElement
                    .computeIfAbsent(each.name(), name -> new ArrayList<>())
                    .add(each.attribute("name")));
    assertThat(page.text())
        .contains(
            byElement.entrySet().stream()
                .map(
                    each ->
                        "| `" + each.getKey() + "` | " + String.join(", ", each.getValue()) + " |")
                .collect(Collectors.joining("\n")));
  }
}
