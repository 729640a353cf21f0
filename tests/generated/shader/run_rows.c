/* Runs compute shaders on a Vulkan device, a software one if there is any.
   run_rows LIST: each line of LIST has a SPIR-V file, an input file, an output file, the bytes of the output and the number of
   groups. Bindings 0 and 1 are the input and the output. Exits 77 where no loader or device is there. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>

static void must(VkResult r, const char *what) {
  if (r != VK_SUCCESS) {
    fprintf(stderr, "%s: VkResult %d\n", what, (int)r);
    exit(1);
  }
}

static void *read_file(const char *path, size_t *size) {
  FILE *f = fopen(path, "rb");
  if (!f || fseek(f, 0, SEEK_END) != 0) {
    fprintf(stderr, "%s: cannot be read\n", path);
    exit(1);
  }
  *size = (size_t)ftell(f);
  rewind(f);
  void *bytes = malloc(*size);
  if (!bytes || fread(bytes, 1, *size, f) != *size)
    exit(1);
  fclose(f);
  return bytes;
}

static VkPhysicalDevice chosen;
static VkDevice device;
static VkQueue queue;
static VkCommandPool pool;

static void open_device(void) {
  const VkApplicationInfo application = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_1};
  const VkInstanceCreateInfo instance_info = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                              .pApplicationInfo = &application};
  VkInstance instance;
  uint32_t many = 0;
  if (vkCreateInstance(&instance_info, NULL, &instance) != VK_SUCCESS ||
      vkEnumeratePhysicalDevices(instance, &many, NULL) != VK_SUCCESS || many == 0) {
    fprintf(stderr, "no Vulkan device\n");
    exit(77);
  }
  VkPhysicalDevice *all = malloc(many * sizeof *all);
  must(vkEnumeratePhysicalDevices(instance, &many, all), "devices");
  chosen = all[0];
  VkPhysicalDeviceProperties properties;
  for (uint32_t i = 0; i < many; ++i) {
    vkGetPhysicalDeviceProperties(all[i], &properties);
    if (properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU)
      chosen = all[i];
  }
  vkGetPhysicalDeviceProperties(chosen, &properties);
  printf("%s\n", properties.deviceName);
  const float priority = 1;
  /* Family 0 of every device that computes at all takes compute work where it is a software one. */
  const VkDeviceQueueCreateInfo queue_info = {
      .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
  const VkDeviceCreateInfo device_info = {
      .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .queueCreateInfoCount = 1, .pQueueCreateInfos = &queue_info};
  must(vkCreateDevice(chosen, &device_info, NULL, &device), "device");
  vkGetDeviceQueue(device, 0, 0, &queue);
  const VkCommandPoolCreateInfo pool_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  must(vkCreateCommandPool(device, &pool_info, NULL, &pool), "pool");
}

struct buffer {
  VkBuffer handle;
  VkDeviceMemory memory;
  void *at;
};

static struct buffer new_buffer(size_t bytes) {
  struct buffer b;
  const VkBufferCreateInfo info = {
      .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = bytes, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
  must(vkCreateBuffer(device, &info, NULL, &b.handle), "buffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device, b.handle, &needs);
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(chosen, &memory);
  const VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  uint32_t type = 0;
  while (type < memory.memoryTypeCount &&
         !((needs.memoryTypeBits >> type & 1) && (memory.memoryTypes[type].propertyFlags & wanted) == wanted))
    ++type;
  const VkMemoryAllocateInfo room = {
      .sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, .allocationSize = needs.size, .memoryTypeIndex = type};
  must(vkAllocateMemory(device, &room, NULL, &b.memory), "memory");
  must(vkBindBufferMemory(device, b.handle, b.memory, 0), "bind");
  must(vkMapMemory(device, b.memory, 0, bytes, 0, &b.at), "map");
  return b;
}

static void free_buffer(struct buffer b) {
  vkDestroyBuffer(device, b.handle, NULL);
  vkFreeMemory(device, b.memory, NULL);
}

static void run(const char *shader, const char *from, const char *to, size_t bytes, uint32_t groups) {
  size_t code_size, in_size;
  uint32_t *code = read_file(shader, &code_size);
  void *rows = read_file(from, &in_size);
  struct buffer buffers[2] = {new_buffer(in_size), new_buffer(bytes)};
  memcpy(buffers[0].at, rows, in_size);
  memset(buffers[1].at, 0xff, bytes);
  VkDescriptorSetLayoutBinding bindings[2] = {0};
  for (uint32_t i = 0; i < 2; ++i) {
    bindings[i].binding = i;
    bindings[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    bindings[i].descriptorCount = 1;
    bindings[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
  }
  const VkDescriptorSetLayoutCreateInfo set_info = {
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 2, .pBindings = bindings};
  VkDescriptorSetLayout set_layout;
  must(vkCreateDescriptorSetLayout(device, &set_info, NULL, &set_layout), "set layout");
  const VkPipelineLayoutCreateInfo layout_info = {
      .sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO, .setLayoutCount = 1, .pSetLayouts = &set_layout};
  VkPipelineLayout layout;
  must(vkCreatePipelineLayout(device, &layout_info, NULL, &layout), "layout");
  const VkShaderModuleCreateInfo module_info = {
      .sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO, .codeSize = code_size, .pCode = code};
  VkShaderModule module;
  must(vkCreateShaderModule(device, &module_info, NULL, &module), shader);
  const VkComputePipelineCreateInfo pipeline_info = {
      .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
      .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                .module = module,
                .pName = "main"},
      .layout = layout};
  VkPipeline pipeline;
  must(vkCreateComputePipelines(device, VK_NULL_HANDLE, 1, &pipeline_info, NULL, &pipeline), shader);
  const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
  const VkDescriptorPoolCreateInfo sets_info = {
      .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
  VkDescriptorPool sets;
  must(vkCreateDescriptorPool(device, &sets_info, NULL, &sets), "sets");
  const VkDescriptorSetAllocateInfo one = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                           .descriptorPool = sets,
                                           .descriptorSetCount = 1,
                                           .pSetLayouts = &set_layout};
  VkDescriptorSet set;
  must(vkAllocateDescriptorSets(device, &one, &set), "set");
  for (uint32_t i = 0; i < 2; ++i) {
    const VkDescriptorBufferInfo whole = {buffers[i].handle, 0, VK_WHOLE_SIZE};
    const VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                        .dstSet = set,
                                        .dstBinding = i,
                                        .descriptorCount = 1,
                                        .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                        .pBufferInfo = &whole};
    vkUpdateDescriptorSets(device, 1, &write, 0, NULL);
  }
  const VkCommandBufferAllocateInfo commands_info = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                                     .commandPool = pool,
                                                     .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                                     .commandBufferCount = 1};
  VkCommandBuffer commands;
  must(vkAllocateCommandBuffers(device, &commands_info, &commands), "commands");
  const VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  must(vkBeginCommandBuffer(commands, &begin), "begin");
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, 1, &set, 0, NULL);
  vkCmdDispatch(commands, groups, 1, 1);
  must(vkEndCommandBuffer(commands), "end");
  const VkSubmitInfo submit = {
      .sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1, .pCommandBuffers = &commands};
  must(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), "submit");
  must(vkQueueWaitIdle(queue), "wait");
  FILE *out = fopen(to, "wb");
  if (!out || fwrite(buffers[1].at, 1, bytes, out) != bytes || fclose(out) != 0)
    must(VK_ERROR_UNKNOWN, to);
  vkFreeCommandBuffers(device, pool, 1, &commands);
  vkDestroyDescriptorPool(device, sets, NULL);
  vkDestroyPipeline(device, pipeline, NULL);
  vkDestroyShaderModule(device, module, NULL);
  vkDestroyPipelineLayout(device, layout, NULL);
  vkDestroyDescriptorSetLayout(device, set_layout, NULL);
  free_buffer(buffers[0]);
  free_buffer(buffers[1]);
  free(code);
  free(rows);
}

int main(int argc, char **argv) {
  FILE *list = argc == 2 ? fopen(argv[1], "r") : NULL;
  if (!list)
    return 2;
  open_device();
  char shader[500], from[500], to[500];
  size_t bytes;
  unsigned groups;
  while (fscanf(list, "%499s %499s %499s %zu %u", shader, from, to, &bytes, &groups) == 5)
    run(shader, from, to, bytes, groups);
  fclose(list);
  return 0;
}
