/**
 * What every module's Gradle build has in common. What only one module needs stands in that module's own script.
 */
package org.u2sa.build;
