/**
 * The test kit for authors of services: a system of one or more services in simulated time, without
 * broker or sleep, a free port where a test needs a broker after all, the repository, and programs
 * not in Java. What only one module's tests need stays in that module.
 */
package org.u2sa.testkit;
