package org.u2sa.gcs.dependencies;

import java.time.LocalDate;

/**
 * A library of someone else's.
 *
 * @param name group:artifact
 * @param released when this version was built
 * @param use "run", "test" or "android"
 */
record Library(String name, String version, LocalDate released, String use, String licence) {
  String artifact() {
    return name.substring(name.indexOf(':') + 1);
  }
}
