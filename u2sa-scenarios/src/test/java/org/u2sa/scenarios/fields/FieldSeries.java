package org.u2sa.scenarios.fields;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Many fields, one after the other, and what is asked of all. */
final class FieldSeries {
  private static final Path PICTURES = Path.of(System.getProperty("java.io.tmpdir"), "u2sa-fields");

  /** Runs one field. */
  interface Runner {
    FieldResult run(RandomField field);
  }

  /** Says whether a field can be solved. */
  interface Oracle {
    boolean isSolvable(RandomField field);
  }

  private final RandomField.Kind kind;
  private final Runner runner;
  private final Oracle oracle;
  private int solvable;
  private int solved;
  private final List<String> contacts = new ArrayList<>();
  private final List<String> touchedBy = new ArrayList<>(); // the vehicle stood or backed off
  private final List<String> silent = new ArrayList<>();
  private final List<String> unsolved = new ArrayList<>();

  FieldSeries(RandomField.Kind kind, Runner runner, Oracle oracle) {
    this.kind = kind;
    this.runner = runner;
    this.oracle = oracle;
  }

  void run(long from, long to) {
    for (long seed = from; seed < to; seed++) {
      RandomField field = new RandomField(kind, seed);
      FieldResult result = runner.run(field);
      boolean canBe = oracle.isSolvable(field);
      solvable += canBe ? 1 : 0;
      solved += canBe && result.reached() ? 1 : 0;
      String name = "field " + seed;
      if (!result.contacts().isEmpty()) {
        contacts.add(name + " " + result.contacts());
      }
      if (!result.touchedBy().isEmpty()) {
        touchedBy.add(name + " " + result.touchedBy());
      }
      if (!result.reached() && !result.gaveUp()) {
        silent.add(name);
      }
      if (canBe && !result.reached()) {
        unsolved.add(name + ": " + result.reason());
      }
      if (!result.contacts().isEmpty() || (canBe && !result.reached())) {
        FieldPicture.write(PICTURES.resolve(kind.traffic() + "-" + seed + ".png"), field, result);
      }
    }
    System.out.printf(
        "%d fields: %d solvable, %d of them solved, contacts %s, touched by %s, unsolved %s%n",
        to - from, solvable, solved, contacts, touchedBy, unsolved);
  }

  /** No contact; each goal reached or given up with a reason; nearly all that can be solved are. */
  void check(double share) {
    assertThat(contacts).as("contacts").isEmpty();
    assertThat(silent).as("neither reached nor given up").isEmpty();
    assertThat((double) solved / solvable)
        .as("solved, but %s", unsolved)
        .isGreaterThanOrEqualTo(share);
  }
}
