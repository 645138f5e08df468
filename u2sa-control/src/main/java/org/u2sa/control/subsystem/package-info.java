/**
 * Control of subsystems: gimbals and manipulators, which follow the navigation points that planners
 * publish for them. The vehicle itself is controlled in the neighbouring packages.
 */
package org.u2sa.control.subsystem;
