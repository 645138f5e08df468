package org.u2sa.build;

import java.util.SortedSet;

/**
 * One declared dependency of one module, in words that both builds share.
 *
 * @param name group and artifact, with ":test-fixtures" where the other module's test kit is meant
 * @param exclusions what it must not bring, each a group or group:artifact; {@link #EVERYTHING} if
 *     nothing
 */
record Dependency(String name, String version, Scope scope, SortedSet<String> exclusions)
    implements Comparable<Dependency> {
  /** Maven's exclusion of all artifacts, Gradle's isTransitive = false. */
  static final String EVERYTHING = "*";

  enum Scope {
    /** Maven's compile, Gradle's api. */
    COMPILE,
    /** Maven's provided, Gradle's compileOnly. */
    PROVIDED,
    RUNTIME,
    TEST
  }

  @Override
  public int compareTo(Dependency other) {
    return toString().compareTo(other.toString());
  }

  @Override
  public String toString() {
    return name
        + ":"
        + version
        + " "
        + scope
        + (exclusions.isEmpty() ? "" : " without " + exclusions);
  }
}
