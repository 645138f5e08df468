package org.u2sa.scenarios.igvc;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.scenarios.run.CommandLineRun;

/** Runs of {@code u2sa demo igvc} on a test's own course. */
final class IgvcRun {
  private IgvcRun() {}

  static CommandLineRun of(Path directory, Course course, long seed, String... options) {
    Path file = directory.resolveSibling(directory.getFileName() + ".xml");
    CourseFile.write(course, file);
    List<String> all = new ArrayList<>(List.of("--course", file.toString(), "--seed", "" + seed));
    all.addAll(List.of(options));
    return CommandLineRun.demo("igvc", directory, all.toArray(new String[0]));
  }
}
