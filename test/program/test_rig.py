# SPDX-FileCopyrightText: 2026 The CSCD developers
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Usage: test_rig.py PROGRAM MESH FOLDER THREE_JS_DIR | test_rig.py PROGRAM MESH FOLDER
# Writes a rig of the mesh and lets another program read it: three.js in headless Chromium, where a joint is turned, or
# without its folder the validator of Khronos (the npm package gltf-validator, which npm, if installed, fetches into
# FOLDER). Leaves with status 77 if the reader is missing; in continuous integration, three.js is required.

import base64
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

SKIPPED = 77
VALIDATOR = "gltf-validator@2.0.0-dev.3.10"

VALIDATE = """
const fs = require('fs');
require('gltf-validator').validateBytes(new Uint8Array(fs.readFileSync(process.argv[1])))
  .then(report => console.log(JSON.stringify(report.issues)));
"""

# Turns the joint that moves the largest part below a quarter of the mesh, and reports the moved vertices.
PAGE = """<!DOCTYPE html><meta charset="utf-8"><pre id="result"></pre>
<script>THREE_JS</script><script>LOADER</script><script>
const bytes = Uint8Array.from(atob("RIG"), c => c.charCodeAt(0)).buffer;
new THREE.GLTFLoader().parse(bytes, '', gltf => {
  gltf.scene.updateMatrixWorld(true);
  let mesh;
  gltf.scene.traverse(object => { mesh = object.isSkinnedMesh ? object : mesh; });
  const {skinIndex, skinWeight, position} = mesh.geometry.attributes;
  const bones = mesh.skeleton.bones;
  const places = () => { // what the shader computes
    gltf.scene.updateMatrixWorld(true);
    mesh.skeleton.update();
    const matrix = new THREE.Matrix4();
    return Array.from({length: position.count}, (_, v) => {
      const place = new THREE.Vector3();
      for (let i = 4 * v; i < 4 * v + 4; ++i) {
        matrix.fromArray(mesh.skeleton.boneMatrices, 16 * skinIndex.array[i]);
        const bound = new THREE.Vector3().fromBufferAttribute(position, v).applyMatrix4(mesh.bindMatrix);
        place.addScaledVector(bound.applyMatrix4(matrix), skinWeight.array[i]);
      }
      return place.applyMatrix4(mesh.bindMatrixInverse);
    });
  };
  const shares = bone => { // of the weights of each vertex
    const below = new Set();
    bone.traverse(b => below.add(bones.indexOf(b)));
    return Array.from({length: position.count}, (_, v) => [0, 1, 2, 3].reduce((sum, i) =>
      sum + (below.has(skinIndex.array[4 * v + i]) ? skinWeight.array[4 * v + i] : 0), 0));
  };
  const whole = bones.map(bone => shares(bone).filter(share => share > 0.99).length);
  const few = whole.map(count => count < position.count / 4 ? count : 0);
  const joint = bones[few.indexOf(Math.max(...few))];
  const share = shares(joint);
  const before = places();
  joint.rotation.set(0.4, 0.3, 0.2);
  const after = places();
  const size = new THREE.Box3().setFromBufferAttribute(position).getSize(new THREE.Vector3()).length();
  const moved = before.map((place, v) => place.distanceTo(after[v]) > 1e-6 * size);
  const at_rest = before.every((place, v) =>
    place.distanceTo(new THREE.Vector3().fromBufferAttribute(position, v)) < 1e-5 * size);
  document.getElementById('result').textContent = JSON.stringify({
    bones: bones.length, vertices: position.count, at_rest, joint: joint.name,
    moved: moved.filter(m => m).length, moved_without_weight: moved.filter((m, v) => m && share[v] === 0).length,
    still_with_all_weight: moved.filter((m, v) => !m && share[v] > 0.99).length});
}, error => { document.getElementById('result').textContent = JSON.stringify({error: String(error)}); });
</script>
"""


def validate(rig, folder):
    """Whether the validator was there. Fails if it complains."""
    node, npm = shutil.which("node"), shutil.which("npm")
    if not (folder / "node_modules/gltf-validator").is_dir() and npm:
        subprocess.run([npm, "install", "--no-audit", "--no-fund", "--fetch-retries=0", "--prefix", str(folder),
                        VALIDATOR], check=False, timeout=60, capture_output=True)
    if not node or not (folder / "node_modules/gltf-validator").is_dir():
        print("skipped: the npm package gltf-validator is not there")
        return False
    output = subprocess.run([node, "-e", VALIDATE, str(rig)], check=True, timeout=60, cwd=folder, capture_output=True,
                            text=True).stdout
    issues = json.loads(output)
    if issues["numErrors"] + issues["numWarnings"] + issues["numInfos"] > 0:
        sys.exit(f"the validator of Khronos complains: {output}")
    print("valid")
    return True


def load(rig, folder, three):
    """Whether three.js and Chromium were there. Fails if the joint does not move its limb alone."""
    scripts = [three / "build/three.min.js", three / "examples/js/loaders/GLTFLoader.js"]
    browser = next(filter(None, map(shutil.which, ["chromium", "chromium-browser", "google-chrome"])), None)
    if not browser or not all(script.is_file() for script in scripts):
        print("skipped: Chromium or the loader of three.js is not there")
        return False
    page = folder / "rig.html"
    text = PAGE.replace("RIG", base64.b64encode(rig.read_bytes()).decode())
    for name, script in zip(["THREE_JS", "LOADER"], scripts):
        text = text.replace(name, script.read_text(encoding="utf-8"))
    page.write_text(text, encoding="utf-8")
    command = [browser, "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
               "--disable-background-networking", "--disable-component-update", "--disable-sync",
               "--disable-dev-shm-usage", "--virtual-time-budget=5000", f"--user-data-dir={folder / 'profile'}",
               "--dump-dom", page.resolve().as_uri()]
    dom = subprocess.run(command, check=True, timeout=120, capture_output=True, text=True).stdout
    match = re.search(r'<pre id="result">(\{.*?\})</pre>', dom)
    print(match.group(1) if match else dom[:1000])
    result = json.loads(match.group(1))
    if not (result["at_rest"] and result["moved"] > 0 and result["moved"] < result["vertices"] / 2
            and result["moved_without_weight"] == 0 and result["still_with_all_weight"] == 0):
        sys.exit("the joint does not move its limb alone")
    return True


def main():
    program, mesh, folder, *three = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    rig = folder / "rig.glb"
    subprocess.run([program, "skeletonize", mesh, "-o", str(rig), "-q"], check=True, timeout=120)
    if not three:
        sys.exit(0 if validate(rig, folder) else SKIPPED)
    if not load(rig, folder, pathlib.Path(three[0])):
        sys.exit("continuous integration has to have them" if os.environ.get("CI") else SKIPPED)


main()
