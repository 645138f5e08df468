package org.u2sa.docs;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * No file names a package registry's host: where packages come from is chosen by whoever builds,
 * and pages of a registry are no source.
 */
class RegistryHostsTest {
  private static final Set<String> NOT_OURS =
      Set.of(".git", "target", "build", ".gradle", "out", "node_modules", "__pycache__");

  /** Words in the names of registries' hosts; the names themselves are not to stand here either. */
  private static final Pattern HOST =
      Pattern.compile(
          "//(?:[\\w-]+\\.)*(?:pypi|pythonhosted|crates|npmjs|mvnrepository|sonatype|jitpack"
              + "|rubygems|anaconda|repo1?\\.maven|maven\\.google|plugins\\.gradle|deb\\.debian)"
              + "\\.[\\w.]+");

  @TempDir private Path folder;

  @Test
  void repository_asItStands_namesNone() throws IOException {
    assertThat(naming(Page.ROOT)).isEmpty();
  }

  @Test
  void naming_linkToARegistry_isFound() throws IOException {
    Files.writeString(folder.resolve("README.md"), "[x 1.0](https:/" + "/pypi.example.org/x/)");
    Files.writeString(folder.resolve("other.md"), "[x 1.0](https:/" + "/example.org/pypi/x)");

    assertThat(naming(folder)).containsExactly("README.md: /" + "/pypi.example.org");
  }

  private static List<String> naming(Path root) throws IOException {
    List<String> found = new ArrayList<>();
    Files.walkFileTree(
        root,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path each, BasicFileAttributes attributes) {
            return NOT_OURS.contains(String.valueOf(each.getFileName()))
                ? FileVisitResult.SKIP_SUBTREE
                : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            if (!attributes.isRegularFile()) {
              return FileVisitResult.CONTINUE; // a link, to what is visited anyway
            }
            Matcher host = HOST.matcher(Files.readString(file, ISO_8859_1));
            if (host.find()) {
              found.add(root.relativize(file) + ": " + host.group());
            }
            return FileVisitResult.CONTINUE;
          }
        });
    return found;
  }
}
