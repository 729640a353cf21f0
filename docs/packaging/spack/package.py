# In an environment, with this file as packages/meetc/package.py of a repository that `spack repo add` knows:
#   spack develop --path CHECKOUT meetc@=main && spack add meetc@main && spack install
from spack.package import *


class Meetc(CMakePackage, CudaPackage):
    """Exact collisions of meshes, and a compiler of geometric algebra."""

    license("MIT")
    version("main")  # of a checkout; `spack develop` names its folder

    variant("cuda", default=False, description="Queries on CUDA devices")

    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("fmt")
    depends_on("tomlplusplus")
    depends_on("cli11")
    depends_on("nlohmann-json")
    depends_on("tinyxml2")
    depends_on("flint")
    depends_on("gmp")
    depends_on("libpng")
    depends_on("freetype")
    depends_on("fontconfig")
    depends_on("cuda@12:", when="+cuda")

    def cmake_args(self):
        return [
            self.define_from_variant("MEETC_CUDA", "cuda"),
            self.define("MEETC_BUILD_TESTS", False),
        ]
