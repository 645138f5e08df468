package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The table of extension points names all of them, and nothing that is not public. */
class ExtendingTest {
  private static final Pattern TYPE = Pattern.compile("`(org\\.u2sa\\.[\\w.]+\\.[A-Z]\\w+)`");

  private static Set<String> named() throws IOException {
    Set<String> named = new TreeSet<>();
    TYPE.matcher(new Page("docs/extending.md").text())
        .results()
        .map(each -> each.group(1))
        .filter(each -> !each.startsWith("org.u2sa.examples."))
        .forEach(named::add);
    return named;
  }

  @Test
  void table_typesNamed_arePublic() throws Exception {
    assertThat(named()).isNotEmpty();
    for (String type : named()) {
      assertThat(Modifier.isPublic(Class.forName(type).getModifiers())).as(type).isTrue();
    }
  }

  @Test
  void table_whatServiceLoaderLooksFor_isNamed() throws IOException {
    Set<String> looked = new TreeSet<>();
    try (Stream<Path> modules = Files.list(Page.ROOT)) {
      for (Path module : modules.toList()) {
        Path lists = module.resolve("src/main/resources/META-INF/services");
        if (Files.isDirectory(lists)) {
          try (Stream<Path> files = Files.list(lists)) {
            files
                .map(file -> file.getFileName().toString())
                .filter(name -> name.startsWith("org.u2sa."))
                .forEach(looked::add);
          }
        }
      }
    }
    assertThat(named()).containsAll(looked);
  }
}
