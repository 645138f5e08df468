package org.u2sa.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every class, signature and test that docs/traceability.md names exists. */
class TraceabilityTest {
  private static final Pattern QUOTED = Pattern.compile("`([^`]+)`");
  private static final Pattern NAMED = Pattern.compile("([A-Z]\\w+)(?:\\.([a-z]\\w+))?");
  private static final Pattern METHOD =
      Pattern.compile("([\\w\\[\\]]+) ([A-Z]\\w+)\\.(\\w+)\\((.*)\\)");
  private static final Pattern FIELD = Pattern.compile("(\\w+) ([A-Z]\\w+)\\.(\\w+)");

  @Test
  void page_everyNameInIt_exists() throws IOException {
    SourceFiles sources = new SourceFiles();
    List<String> quoted = quoted();
    List<String> missing = new ArrayList<>();
    for (String text : quoted) {
      if (!exists(text, sources)) {
        missing.add(text);
      }
    }
    assertThat(missing).isEmpty();
    assertThat(quoted).hasSizeGreaterThan(100);
  }

  private static List<String> quoted() throws IOException {
    String text = new Page("docs/traceability.md").text();
    return QUOTED
        .matcher(text)
        .results()
        .map((MatchResult match) -> match.group(1))
        .filter(name -> !name.startsWith("./") && !name.equals("this type"))
        .toList();
  }

  private static boolean exists(String text, SourceFiles sources) throws IOException {
    Matcher named = NAMED.matcher(text);
    if (named.matches()) {
      return named.group(2) == null
          ? sources.has(named.group(1))
          : sources.hasMethod(named.group(1), named.group(2));
    }
    Matcher method = METHOD.matcher(text);
    if (method.matches()) {
      return sources
          .load(method.group(2))
          .map(type -> hasMethod(type, method.group(1), method.group(3), method.group(4)))
          .orElse(false);
    }
    Matcher field = FIELD.matcher(text);
    return field.matches()
        && sources
            .load(field.group(2))
            .map(type -> hasField(type, field.group(1), field.group(3)))
            .orElse(false);
  }

  private static boolean hasMethod(Class<?> type, String returns, String name, String parameters) {
    return Arrays.stream(type.getMethods())
        .anyMatch(
            method ->
                method.getName().equals(name)
                    && method.getReturnType().getSimpleName().equals(returns)
                    && parameters(method).equals(parameters));
  }

  private static String parameters(Method method) {
    return Stream.of(method.getParameterTypes())
        .map(Class::getSimpleName)
        .collect(Collectors.joining(", "));
  }

  private static boolean hasField(Class<?> type, String fieldType, String name) {
    for (Field field : type.getDeclaredFields()) {
      if (field.getName().equals(name) && field.getType().getSimpleName().equals(fieldType)) {
        return true;
      }
    }
    return false;
  }
}
