package org.u2sa.docs;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectMotion;
import org.u2sa.messages.schema.MessageType;

/** What classes, fields and constants mean: the words of their Javadoc, for the wire protocol. */
final class Meanings {
  private static final String COMMENT = "/\\*\\*((?:(?!\\*/).)*)\\*/\\s*";

  /** Getters that several fields share, by what stands for the fields' first letter. */
  private static final Map<String, String> TRIPLES =
      Map.of("Dot", "velocity", "Sigma", "sigma", "", "anchor");

  private Meanings() {}

  static String ofClass(Class<?> type) {
    return found(source(type), "public (?:final |abstract )*class " + type.getSimpleName(), type);
  }

  static String ofField(MessageType<?> type, String field) {
    String constant = "private static final [^;=]*=\\s*SCHEMA\\.\\w+\\(\"" + field + "\"";
    for (Class<?> each = type.messageClass(); each != Object.class; each = each.getSuperclass()) {
      String getter = "public (?:final )?[\\w<>.? ]+ " + field + "\\(\\)";
      if (Pattern.compile(getter).matcher(source(each)).find()) {
        return found(source(each), getter, field);
      }
      if (Pattern.compile(COMMENT + constant, Pattern.DOTALL).matcher(source(each)).find()) {
        return found(source(each), constant, field); // shares its getter
      }
    }
    String triple = TRIPLES.get(field.substring(1));
    for (Class<?> each : List.of(type.messageClass(), ObjectMotion.class)) {
      boolean has = each != ObjectMotion.class || isObject(type);
      for (String name : triple == null ? List.of(field) : List.of(field, triple)) {
        String getter = "public [\\w<>.?\\[\\] ]+ " + name + "\\(\\)";
        if (has && Pattern.compile(getter).matcher(source(each)).find()) {
          return found(source(each), getter, field);
        }
      }
    }
    return found(source("org.u2sa.messages.StateField"), "\\w+\\(\"" + field + "\",", field);
  }

  private static boolean isObject(MessageType<?> type) {
    return ObjectDescription.class.isAssignableFrom(type.messageClass());
  }

  static String ofConstant(Object constant) {
    return found(source(constant.getClass()), constant + "[,;\\s]", constant);
  }

  private static String found(String source, String declaration, Object what) {
    Matcher comment =
        Pattern.compile(COMMENT + "(?:@\\w+\\s+)*" + declaration, Pattern.DOTALL).matcher(source);
    if (!comment.find()) {
      throw new AssertionError(what + " has no Javadoc of which the wire protocol could tell");
    }
    return comment
        .group(1)
        .replaceAll("\\s*\\n\\s*\\* ?", " ")
        .replaceAll("<p>.*", "")
        .replaceAll(" @throws .*", "")
        .replaceAll("\\{@(?:link|code) (?:\\w*#)?(\\w+)(?:\\(\\))?}", "$1")
        .replaceAll(" \\(thesis [^)]*\\)", "")
        .replace("|", "\\|")
        .trim();
  }

  private static String source(Class<?> type) {
    return source(type.getName());
  }

  private static String source(String className) {
    try (Stream<Path> modules = Files.list(Page.ROOT)) {
      String file = "src/main/java/" + className.replace('.', '/') + ".java";
      Path found =
          modules
              .map(module -> module.resolve(file))
              .filter(Files::isRegularFile)
              .findFirst()
              .orElseThrow(() -> new AssertionError("no source of " + className));
      return Files.readString(found);
    } catch (IOException e) {
      throw new UncheckedIOException(className, e);
    }
  }
}
