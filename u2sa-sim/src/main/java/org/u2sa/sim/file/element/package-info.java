/** Elements of vehicle files: values with units and ranges, presets, and changes. */
package org.u2sa.sim.file.element;
