package org.u2sa.architecture;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.lang.ArchCondition;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.lang.ConditionEvents;
import com.tngtech.archunit.lang.SimpleConditionEvent;
import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * Refuses many classes that all need each other, directly or not: none of them can be understood
 * without the others. A few are often one thing in several files. Nested classes count as their
 * outermost one.
 */
final class ClassCircles extends ArchCondition<JavaClass> {
  private static final int MAX_CLASSES = 3;

  private final Map<String, Set<String>> used = new HashMap<>(); // directly, by class
  private final Map<String, Set<String>> reached = new HashMap<>(); // directly or not

  private ClassCircles() {
    super("be in a circle of at most " + MAX_CLASSES);
  }

  static ArchRule ofClassesIn(String... packages) {
    return classes().that().resideInAnyPackage(packages).should(new ClassCircles());
  }

  @Override
  public void init(Collection<JavaClass> all) {
    used.clear();
    reached.clear();
    for (JavaClass type : all) {
      Set<String> targets = used.computeIfAbsent(outermost(type), name -> new HashSet<>());
      type.getDirectDependenciesFromSelf()
          .forEach(each -> targets.add(outermost(each.getTargetClass().getBaseComponentType())));
    }
    used.keySet().forEach(name -> reached.put(name, reachedFrom(name)));
  }

  private Set<String> reachedFrom(String start) {
    Set<String> found = new TreeSet<>();
    Deque<String> open = new ArrayDeque<>(Set.of(start));
    while (!open.isEmpty()) {
      for (String next : used.get(open.pop())) {
        if (used.containsKey(next) && found.add(next)) {
          open.push(next);
        }
      }
    }
    return found;
  }

  @Override
  public void check(JavaClass type, ConditionEvents events) {
    String name = type.getName();
    Set<String> circle = new TreeSet<>(reached.getOrDefault(name, Set.of())); // none if nested
    circle.removeIf(other -> !reached.get(other).contains(name));
    if (circle.size() > MAX_CLASSES && circle.iterator().next().equals(name)) { // told once
      events.add(SimpleConditionEvent.violated(type, "all need each other: " + circle));
    }
  }

  private static String outermost(JavaClass type) {
    return type.getEnclosingClass().map(ClassCircles::outermost).orElse(type.getName());
  }
}
