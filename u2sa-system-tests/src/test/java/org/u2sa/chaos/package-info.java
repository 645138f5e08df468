/**
 * Breaks a running Cessna, seeded and in many ways, and judges what becomes of it. How each part
 * handles its own faults is tested beside that part.
 */
package org.u2sa.chaos;
