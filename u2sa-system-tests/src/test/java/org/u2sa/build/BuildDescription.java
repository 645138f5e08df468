package org.u2sa.build;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * All that two builds of the same modules must agree on.
 *
 * @param settings by what they are: group, version, Java release, compiler arguments, excluded tags
 * @param managed versions by group:artifact
 * @param bom the modules that the BOM lists
 * @param everywhere test dependencies of every module
 * @param modules each module's own dependencies
 */
record BuildDescription(
    SortedMap<String, String> settings,
    SortedMap<String, String> managed,
    SortedSet<String> bom,
    SortedSet<Dependency> everywhere,
    SortedMap<String, SortedSet<Dependency>> modules) {

  /** One line a difference, empty where both agree; the other build is called Gradle. */
  List<String> differencesFrom(BuildDescription gradle) {
    List<String> found = new ArrayList<>();
    compare("setting", settings, gradle.settings, found);
    compare("version", managed, gradle.managed, found);
    compare("BOM", bom, gradle.bom, found);
    compare("module", modules.keySet(), gradle.modules.keySet(), found);
    compare("dependency of every module", everywhere, gradle.everywhere, found);
    modules.forEach(
        (module, own) ->
            compare(
                "dependency of " + module,
                own,
                gradle.modules.getOrDefault(module, new TreeSet<>()),
                found));
    return found;
  }

  private static void compare(
      String what,
      SortedMap<String, String> maven,
      SortedMap<String, String> gradle,
      List<String> found) {
    compare(what, entries(maven), entries(gradle), found);
  }

  private static SortedSet<String> entries(SortedMap<String, String> map) {
    SortedSet<String> entries = new TreeSet<>();
    new TreeMap<>(map).forEach((key, value) -> entries.add(key + " = " + value));
    return entries;
  }

  private static <T> void compare(
      String what, Iterable<T> maven, Iterable<T> gradle, List<String> found) {
    SortedSet<String> inMaven = texts(maven);
    SortedSet<String> inGradle = texts(gradle);
    inMaven.stream()
        .filter(text -> !inGradle.contains(text))
        .forEach(text -> found.add(what + " only in Maven: " + text));
    inGradle.stream()
        .filter(text -> !inMaven.contains(text))
        .forEach(text -> found.add(what + " only in Gradle: " + text));
  }

  private static <T> SortedSet<String> texts(Iterable<T> items) {
    SortedSet<String> texts = new TreeSet<>();
    items.forEach(item -> texts.add(item.toString()));
    return texts;
  }
}
