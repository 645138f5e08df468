/**
 * Holds the Maven and the Gradle description of the build together, from the one module that sees
 * all others, and tests the Android application's assembly. What the modules themselves do is
 * tested where they stand.
 */
package org.u2sa.build;
